#include "report/csv.h"

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "base/error.h"

namespace ctpbench {
namespace {

[[noreturn]] void cannot_write(const std::filesystem::path& path, const std::string& why) {
    throw Error(ExitCode::output, path.string() + ": error: cannot be written: " + why +
                                      "; free some space or name another folder with --out");
}

std::string last_error() { return errno != 0 ? std::strerror(errno) : "unknown reason"; }

}  // namespace

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

CsvFile::CsvFile(std::filesystem::path path, const std::vector<std::string>& header)
    : path_(std::move(path)) {
    errno = 0;
    file_.open(path_, std::ios::binary | std::ios::trunc);
    if (!file_) cannot_write(path_, last_error());
    append({header});
}

void CsvFile::append(const std::vector<std::vector<std::string>>& lines) {
    std::string text;
    for (const auto& line : lines) text += csv_line(line);
    errno = 0;
    file_.write(text.data(), static_cast<std::streamsize>(text.size()));
    file_.flush();
    if (!file_) cannot_write(path_, last_error());
}

void write_file(const std::filesystem::path& path, const std::string& content) {
    const std::filesystem::path partial = path.string() + ".partial";
    errno = 0;
    {
        std::ofstream file(partial, std::ios::binary | std::ios::trunc);
        file.write(content.data(), static_cast<std::streamsize>(content.size()));
        file.flush();
        if (!file) cannot_write(path, last_error());
    }
    std::error_code failed;
    std::filesystem::rename(partial, path, failed);
    if (failed) cannot_write(path, failed.message());
}

void create_output_folder(const std::filesystem::path& path) {
    std::error_code failed;
    std::filesystem::create_directories(path, failed);
    if (failed) cannot_write(path, failed.message());
    if (std::filesystem::exists(path / "rows.csv", failed))
        throw Error(ExitCode::output, path.string() +
                                          ": error: holds the results of another run; name another "
                                          "folder with --out, or move this one away");
    write_file(path / ".writable", "");
    std::filesystem::remove(path / ".writable", failed);
}

}  // namespace ctpbench
