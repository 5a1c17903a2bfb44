#include "measure/statistics.h"

#include <algorithm>
#include <random>

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
    constexpr std::size_t resamples = 2000;
    std::mt19937_64 random(1);
    std::vector<double> medians(resamples), drawn(samples.size());
    for (double& m : medians) {
        for (double& d : drawn) d = samples[random() % samples.size()];
        m = median(drawn);
    }
    std::sort(medians.begin(), medians.end());
    e.lo = medians[resamples * 25 / 1000];
    e.hi = medians[resamples * 975 / 1000 - 1];
    return e;
}

Estimate estimate_paired_ratio(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> ratios(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) ratios[i] = a[i] / b[i];
    return estimate_median(ratios);
}

}  // namespace ctpbench
