// CSV as in RFC 4180.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "report/output_file.h"

namespace ctpbench {

std::string csv_line(const std::vector<std::string>& fields);

// A number with as many digits as a reader needs; an empty field for NaN.
std::string csv_number(double value, int significant_digits = 6);

// A file that grows by whole lines.
class CsvFile {
public:
    // Goes on after the first `keep` bytes of what is there; with none of them, it starts with the header.
    // Throws Error(output), as append() does, when it cannot be written.
    CsvFile(std::filesystem::path path, const std::vector<std::string>& header, std::uint64_t keep = 0);
    void append(const std::vector<std::vector<std::string>>& lines);
    GrowingFile& file() { return file_; }

private:
    GrowingFile file_;
};

}  // namespace ctpbench
