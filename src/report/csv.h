// CSV as in RFC 4180, written so that what is there survives whatever happens next.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace ctpbench {

std::string csv_line(const std::vector<std::string>& fields);

// A number with as many digits as a reader needs; an empty field for NaN.
std::string csv_number(double value, int significant_digits = 6);

// A file that grows by whole lines. Throws Error(output), naming the file, when it cannot be written.
class CsvFile {
public:
    CsvFile(std::filesystem::path path, const std::vector<std::string>& header);
    void append(const std::vector<std::vector<std::string>>& lines);

private:
    std::filesystem::path path_;
    std::ofstream file_;
};

// Writes a whole file, atomically by rename. Throws Error(output).
void write_file(const std::filesystem::path& path, const std::string& content);

// Creates the folder of a run. Throws Error(output) if it cannot be written to, or holds another run.
void create_output_folder(const std::filesystem::path& path);

}  // namespace ctpbench
