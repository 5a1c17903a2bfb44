// Reads a CSV file (RFC 4180) back. What is there by another version of the program, or cut short, is an
// error that names the place.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ctpbench {

class CsvTable {
public:
    // Throws Error(usage).
    static CsvTable load(const std::filesystem::path& path);
    static CsvTable parse(std::string_view text, const std::string& file);

    std::size_t lines() const { return fields_.size(); }
    std::size_t columns() const { return names_.size(); }
    // The number of a column; throws Error(usage) if there is none of this name.
    std::size_t column(const std::string& name) const;
    const std::string& field(std::size_t line, std::size_t column) const { return fields_[line][column]; }
    // A field as a number; an empty one as NaN. Throws Error(usage) for any other text.
    double number(std::size_t line, std::size_t column) const;

private:
    [[noreturn]] void fail(std::size_t line, const std::string& problem) const;

    std::string file_;
    std::vector<std::string> names_;
    std::vector<std::vector<std::string>> fields_;
    std::vector<std::size_t> begins_;  // on which line of the file
};

}  // namespace ctpbench
