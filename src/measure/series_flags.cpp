#include "measure/series_flags.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "measure/finding.h"
#include "measure/statistics.h"

namespace ctpbench {
namespace {

constexpr double kMatters = 0.02;

double drift_of(const std::vector<double>& x) {
    const std::size_t n = x.size();
    double s = 0.0;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j) s += (x[j] > x[i]) - (x[j] < x[i]);
    const double size = static_cast<double>(n);
    const double deviation = std::sqrt(size * (size - 1.0) * (2.0 * size + 5.0) / 18.0);
    if ((std::abs(s) - 1.0) / deviation < 2.5758293035489) return 0.0;  // two-sided 1 %
    const auto third = static_cast<std::ptrdiff_t>(n / 3);
    const double drift = median({x.end() - third, x.end()}) / median({x.begin(), x.begin() + third}) - 1.0;
    return std::abs(drift) < kMatters ? 0.0 : drift;
}

bool is_bimodal(std::vector<double> x) {
    std::sort(x.begin(), x.end());
    const std::size_t n = x.size(), least = std::max<std::size_t>(3, (n + 4) / 5);
    // Ashman's distance of the split that leaves the least variance within groups.
    double least_within = INFINITY, distance = 0.0, apart = 0.0;
    for (std::size_t k = least; k + least <= n; ++k) {
        const auto moments = [&](std::size_t from, std::size_t to) {
            double mean = 0.0, square = 0.0;
            for (std::size_t i = from; i < to; ++i) mean += x[i];
            mean /= static_cast<double>(to - from);
            for (std::size_t i = from; i < to; ++i) square += (x[i] - mean) * (x[i] - mean);
            return std::pair{mean, square};
        };
        const auto [low, low_square] = moments(0, k);
        const auto [high, high_square] = moments(k, n);
        if (low_square + high_square >= least_within) continue;
        least_within = low_square + high_square;
        const double variances =
            low_square / static_cast<double>(k) + high_square / static_cast<double>(n - k);
        apart = high / low - 1.0;
        distance = (high - low) * std::sqrt(2.0 / std::max(variances, 1e-24 * high * high));
    }
    // Half a percent of normal series of n values reach this; found by simulation, which a test repeats.
    return apart >= kMatters && distance > 3.5 + 40.0 / static_cast<double>(n);
}

}  // namespace

std::string SeriesFlags::text() const {
    char drifts[32] = "";
    if (drift != 0.0) std::snprintf(drifts, sizeof drifts, "drift %+.1f %%", 100.0 * drift);
    return std::string(drifts) + (drift != 0.0 && bimodal ? ", " : "") + (bimodal ? "bimodal" : "");
}

SeriesFlags flags_of(const std::vector<double>& series) {
    if (series.size() < kLeastRounds) return {};
    if (std::any_of(series.begin(), series.end(), [](double x) { return !(x > 0.0); })) return {};
    return {drift_of(series), is_bimodal(series)};
}

}  // namespace ctpbench
