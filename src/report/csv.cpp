#include "report/csv.h"

#include <cmath>
#include <cstdio>
#include <utility>

namespace ctpbench {
std::string csv_line(const std::vector<std::string>& fields) {
    std::string line;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (i > 0) line += ',';
        if (fields[i].find_first_of(",\"\r\n") == std::string::npos) {
            line += fields[i];
            continue;
        }
        line += '"';
        for (char c : fields[i]) line += c == '"' ? std::string("\"\"") : std::string(1, c);
        line += '"';
    }
    return line + "\r\n";
}

std::string csv_number(double value, int significant_digits) {
    if (std::isnan(value)) return {};
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", significant_digits, value);
    return text;
}

CsvFile::CsvFile(std::filesystem::path path, const std::vector<std::string>& header, std::uint64_t keep)
    : file_(std::move(path), keep) {
    if (keep == 0) append({header});
}

void CsvFile::append(const std::vector<std::vector<std::string>>& lines) {
    std::string text;
    for (const auto& line : lines) text += csv_line(line);
    file_.append(text);
}

}  // namespace ctpbench
