// stability.csv: how often each method fails on each stress workload, and the same as a table for a terminal.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "measure/results.h"
#include "report/csv.h"

namespace ctpbench {

// kind, method, is_default, workload, rays, failures, failures_per_million, lo and hi (a 95 % interval of
// that, per million), p99_scaled_error; then backend and the failures by what they are, and what was left
// undecided.
class StabilityFile {
public:
    explicit StabilityFile(const std::filesystem::path& folder);
    void append(const StabilityRow& row);

private:
    CsvFile file_;
};

// A line per workload and a lettered column per method, in failures per million: "." is none, "-" where the
// two do not meet. The letters are spelled out above, with the backend if there are several; at most 52
// methods.
std::string stability_text(const std::vector<StabilityRow>& rows);

}  // namespace ctpbench
