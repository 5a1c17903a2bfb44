// Medians and their bootstrap intervals.
#pragma once

#include <cstddef>
#include <vector>

namespace ctpbench {

// A median with a 95 % percentile-bootstrap interval.
struct Estimate {
    double median = 0.0, lo = 0.0, hi = 0.0;
};

// `samples` must not be empty.
double median(std::vector<double> samples);

// Resamples with a fixed seed, so equal samples give equal intervals. With fewer than three samples the
// interval is their range.
Estimate estimate_median(const std::vector<double>& samples);

// The median of a[i] / b[i]: both measured in round i, so that what slows the whole machine cancels.
Estimate estimate_paired_ratio(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace ctpbench
