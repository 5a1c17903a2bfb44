// Fuzzes the reader of rows.csv: any text is an error that says so, or a table that is the same once written
// and read back.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "kernels/platform.h"
#include "report/csv.h"
#include "report/csv_table.h"

namespace {

using namespace ctpbench;

std::vector<std::string> line_of(const CsvTable& table, std::size_t line, std::size_t columns) {
    std::vector<std::string> fields;
    for (std::size_t c = 0; c < columns; ++c) fields.push_back(table.field(line, c));
    return fields;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        const CsvTable table = CsvTable::parse(text, "fuzz.csv");
        const std::size_t columns = table.columns();
        std::string written;
        std::vector<std::string> names;
        for (std::size_t c = 0; c < columns; ++c) names.push_back("c" + std::to_string(c));
        written += csv_line(names);
        for (std::size_t i = 0; i < table.lines(); ++i) written += csv_line(line_of(table, i, columns));
        const CsvTable again = CsvTable::parse(written, "again.csv");
        if (again.columns() != columns) trap();
        // A line of one empty field is an empty line, which does not count.
        if (columns > 1 && again.lines() != table.lines()) trap();
        for (std::size_t i = 0; columns > 1 && i < table.lines(); ++i)
            if (line_of(again, i, columns) != line_of(table, i, columns)) trap();
        for (std::size_t i = 0; i < table.lines(); ++i)
            for (std::size_t c = 0; c < columns; ++c) table.number(i, c);
    } catch (const Error& error) {
        if (error.code() != ExitCode::usage || std::string_view(error.what()).empty()) trap();
    }
    return 0;
}
