#include "measure/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "measure/median_distribution.h"

namespace ctpbench {

double median(std::vector<double> samples) {
    std::sort(samples.begin(), samples.end());
    const std::size_t n = samples.size();
    return n % 2 == 1 ? samples[n / 2] : 0.5 * (samples[n / 2 - 1] + samples[n / 2]);
}

Estimate estimate_median(const std::vector<double>& samples) {
    Estimate e;
    e.median = median(samples);
    if (samples.size() < 3) {
        const auto [lo, hi] = std::minmax_element(samples.begin(), samples.end());
        e.lo = *lo, e.hi = *hi;
        return e;
    }
    const MedianDistribution medians(samples);
    e.lo = medians.quantile(0.025), e.hi = medians.quantile(0.975);
    return e;
}

std::vector<double> paired_ratios(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> ratios(std::min(a.size(), b.size()));
    for (std::size_t i = 0; i < ratios.size(); ++i) ratios[i] = a[i] / b[i];
    return ratios;
}

Estimate estimate_paired_ratio(const std::vector<double>& a, const std::vector<double>& b) {
    return estimate_median(paired_ratios(a, b));
}

Interval binomial_interval(std::size_t count, std::size_t trials) {
    const double n = static_cast<double>(trials), p = static_cast<double>(count) / n;
    constexpr double z = 1.959963984540054;
    const double center = (p + z * z / (2.0 * n)) / (1.0 + z * z / n);
    const double half = z / (1.0 + z * z / n) * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
    const double rule_of_three = std::min(1.0, 3.0 / n);
    return {count == 0        ? 0.0
            : count == trials ? 1.0 - rule_of_three
                              : center - half,
            count == trials ? 1.0
            : count == 0    ? rule_of_three
                            : center + half};
}

double nearest_rank(std::vector<float> values, double share) {
    std::erase_if(values, [](float v) { return std::isnan(v); });
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    const double n = static_cast<double>(values.size());
    const auto rank = static_cast<std::size_t>(std::clamp(std::ceil(share * n), 1.0, n)) - 1;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank), values.end());
    return values[rank];
}

}  // namespace ctpbench
