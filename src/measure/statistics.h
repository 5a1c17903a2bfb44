// Medians and their bootstrap intervals; counts and their binomial ones; percentiles.
#pragma once

#include <cstddef>
#include <vector>

namespace ctpbench {

// A median with a 95 % percentile-bootstrap interval (measure/median_distribution.h).
struct Estimate {
    double median = 0.0, lo = 0.0, hi = 0.0;
};

// `samples` must not be empty.
double median(std::vector<double> samples);

// With fewer than three samples the interval is their range.
Estimate estimate_median(const std::vector<double>& samples);

// a[i] / b[i], as far as there are both.
std::vector<double> paired_ratios(const std::vector<double>& a, const std::vector<double>& b);

// The median of a[i] / b[i]: both measured in round i, so that what slows the whole machine cancels.
Estimate estimate_paired_ratio(const std::vector<double>& a, const std::vector<double>& b);

// A 95 % interval of the probability behind `count` events in `trials` > 0 independent trials. Wilson's score
// interval ("Probable Inference, the Law of Succession, and Statistical Inference", J. Am. Stat. Assoc.
// 22(158), 1927), but for none, which is reported as at most 3 / trials (Hanley & Lippman-Hand, "If Nothing
// Goes Wrong, Is Everything All Right?", JAMA 249(13), 1983), and likewise for all.
struct Interval {
    double lo = 0.0, hi = 1.0;
};
Interval binomial_interval(std::size_t count, std::size_t trials);

// The value of nearest rank: the smallest one that at least this share of the values does not exceed. NaN
// values do not count; NaN if there are no others.
double nearest_rank(std::vector<float> values, double share);

}  // namespace ctpbench
