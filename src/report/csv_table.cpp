#include "report/csv_table.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <limits>
#include <sstream>
#include <system_error>

#include "base/error.h"
#include "base/memory.h"

namespace ctpbench {

CsvTable CsvTable::load(const std::filesystem::path& path) {
    // Fields of one letter take this many times their bytes in memory.
    constexpr double kGrowth = 40;
    std::error_code failed;
    if (std::filesystem::is_regular_file(path, failed))
        require_memory(kGrowth * static_cast<double>(std::filesystem::file_size(path, failed)), path.string(),
                       "keep fewer rows in one file");
    else
        failed = std::make_error_code(std::errc::invalid_argument);  // a pipe or a device may never end
    std::ifstream file;
    if (!failed) file.open(path, std::ios::binary);
    std::stringstream text;
    if (!file.is_open() || !(text << file.rdbuf()))
        throw Error(ExitCode::usage, path.string() + ": error: cannot be read, or is empty");
    return parse(text.view(), path.string());
}

CsvTable CsvTable::parse(std::string_view text, const std::string& file) {
    CsvTable table;
    table.file_ = file;
    std::size_t line = 1, begin = 1;
    std::vector<std::string> fields(1);
    bool quoted = false, was_quoted = false;
    const auto end_of_record = [&] {
        if (fields.size() == 1 && fields[0].empty() && !was_quoted) return;  // an empty line
        if (table.names_.empty()) {
            table.names_ = fields;
        } else {
            if (fields.size() != table.names_.size())
                table.fail(begin, std::to_string(fields.size()) + " fields where the first line has " +
                                      std::to_string(table.names_.size()) +
                                      "; a line that was cut short can be removed");
            table.fields_.push_back(fields), table.begins_.push_back(begin);
        }
        fields.assign(1, "");
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted) {
            line += c == '\n';
            if (c != '"')
                fields.back() += c;
            else if (i + 1 < text.size() && text[i + 1] == '"')
                fields.back() += text[++i];
            else
                quoted = false;
        } else if (c == '"' && fields.back().empty()) {
            quoted = was_quoted = true;
        } else if (c == ',') {
            fields.emplace_back();
        } else if (c == '\n') {
            end_of_record();
            was_quoted = false, begin = ++line;
        } else if (c != '\r' || i + 1 == text.size() || text[i + 1] != '\n') {
            fields.back() += c;
        }
    }
    if (quoted) table.fail(begin, "a quote that is never closed");
    end_of_record();
    if (table.names_.empty()) table.fail(1, "no line with the names of columns");
    return table;
}

std::size_t CsvTable::column(const std::string& name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end())
        fail(1, "no column \"" + name + "\"; another version wrote this, measure again");
    return static_cast<std::size_t>(found - names_.begin());
}

double CsvTable::number(std::size_t line, std::size_t column) const {
    const std::string& text = field(line, column);
    if (text.empty()) return std::numeric_limits<double>::quiet_NaN();
    double value = 0.0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc() || end != text.data() + text.size())
        fail(begins_[line], "column \"" + names_[column] + "\" holds \"" + text + "\", which is no number");
    return value;
}

void CsvTable::fail(std::size_t line, const std::string& problem) const {
    throw Error(ExitCode::usage, file_ + ":" + std::to_string(line) + ": error: " + problem);
}

}  // namespace ctpbench
