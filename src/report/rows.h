// rows.csv: one line per repetition, kernel and bounce, with all that identifies it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "measure/results.h"
#include "report/csv.h"

namespace ctpbench {

class RowsFile {
public:
    // `threads`: of those that do not ask for a number of their own. Goes on after the first `keep` bytes of
    // what is there.
    RowsFile(const std::filesystem::path& folder, std::string run_id, std::string experiment, int threads,
             std::uint64_t keep = 0);
    GrowingFile& file() { return file_.file(); }
    void append(const Results& results, const std::vector<Row>& rows);

private:
    int threads_of(const Contender& contender) const;

    CsvFile file_;
    std::string run_id_, experiment_;
    int threads_;
};

}  // namespace ctpbench
