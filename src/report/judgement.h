// What the rounds of one run say of its contenders beside the run's reference: a verdict on each one's main
// kernel, tested together, and what makes a line of summary.csv doubtful.
#pragma once

#include <string>
#include <vector>

#include "config/config.h"
#include "measure/results.h"
#include "measure/series_flags.h"

namespace ctpbench {

// Of one contender and kernel.
struct Judgement {
    std::string verdict;  // SAME, FASTER, SLOWER, UNCLEAR; empty for other kernels than the main one, and
                          // where there is nobody to be compared with
    SeriesFlags flags;    // of the ratios that the verdict rests on
};

class Judgements {
public:
    Judgements(const Config& config, const Results& results);
    // Of a cell of these results; null if there is none.
    const Judgement* find(const CellResult& cell, std::string_view kernel) const;
    // A line for each that is doubtful, and one if there were too few rounds for every verdict.
    std::vector<std::string> warnings() const;

private:
    struct Line {
        const CellResult* cell;
        std::string kernel;
        Judgement judgement;
    };
    std::vector<Line> lines_;
    std::string shortage_;
};

// Relative half-width of the 95 % interval of what the cell is judged by: its ratio to the reference; the
// reference's own to the yardstick; speed where there is neither. 0 for a cell without figures.
double noise_of(const CellResult& cell, const Results& results, const std::string& reference);

}  // namespace ctpbench
