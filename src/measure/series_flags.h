// What makes a series of rounds doubtful: that it drifts, or that it falls into two groups. A median with an
// interval hides both. They are told, never acted upon: no round is dropped.
#pragma once

#include <string>
#include <vector>

namespace ctpbench {

struct SeriesFlags {
    double drift = 0.0;  // the last third's median over the first third's, minus one; 0: no trend
    bool bimodal = false;

    bool any() const { return drift != 0.0 || bimodal; }
    // "drift -4.1 %, bimodal"; empty for none.
    std::string text() const;
};

// A drift needs a trend at the level of 1 % (Mann, "Nonparametric Tests Against Trend", Econometrica 13(3),
// 1945) of 2 % or more. Two groups, each with a fifth of the rounds or more, need means that are 2 % or more
// apart and a distance (Ashman, Bird & Zepf, "Detecting Bimodality in Astronomical Datasets", Astron. J.
// 108(6), 1994) that one bell curve cut in two does not reach. Fewer than nine positive values: neither.
SeriesFlags flags_of(const std::vector<double>& series);

}  // namespace ctpbench
