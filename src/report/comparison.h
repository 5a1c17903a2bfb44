// Two folders of results beside each other: what has become faster or slower, what cannot be told, and what
// is in one of them alone.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "measure/finding.h"
#include "measure/statistics.h"
#include "report/recorded_results.h"

namespace ctpbench {

// One contender's kernel in both.
struct ComparedKernel {
    std::string name;
    bool yardstick = false;   // what is not under test: shown, but no regression
    bool normalised = false;  // figures are multiples of the yardstick's speed; else Mrays/s
    double base = 0.0, fresh = 0.0;
    std::size_t base_rounds = 0, fresh_rounds = 0;
    Estimate ratio;  // fresh / base, with a 95 % interval
    Finding finding = Finding::unclear;
    bool regression = false;  // the interval, widened for the number of comparisons, ends below the limit
};

struct Comparison {
    std::vector<ComparedKernel> kernels;
    std::vector<std::string> unmatched;    // what is in both or one of them, and was not compared: why
    std::vector<std::string> differences;  // of machines and builds
    std::vector<std::string> warnings;
    bool other_machine = false;

    bool has_regression() const;
    // Whether anything under test is UNCLEAR, or was not compared.
    bool has_doubt() const;
};

Comparison compare(const RecordedResults& base, const RecordedResults& fresh, double fail_ratio);

// For a terminal.
std::string comparison_text(const Comparison& comparison, double fail_ratio);

}  // namespace ctpbench
