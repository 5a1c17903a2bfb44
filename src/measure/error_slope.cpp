#include "measure/error_slope.h"

#include <cmath>
#include <cstddef>

namespace ctpbench {
namespace {

// Of all seeds but one; `skipped` = their number: of all.
double slope_without(const std::vector<std::vector<double>>& relmse, std::size_t skipped) {
    const std::size_t points = relmse.front().size();
    const double middle = 0.5 * static_cast<double>(points - 1);
    double products = 0.0, squares = 0.0;
    for (std::size_t k = 0; k < points; ++k) {
        double sum = 0.0;
        for (std::size_t s = 0; s < relmse.size(); ++s)
            if (s != skipped) sum += relmse[s][k];
        const double count = static_cast<double>(relmse.size() - (skipped < relmse.size() ? 1 : 0));
        const double x = static_cast<double>(k) - middle;
        products += x * 0.5 * std::log2(sum / count);
        squares += x * x;
    }
    return products / squares;
}

}  // namespace

BoundedValue rmse_slope(const std::vector<std::vector<double>>& relmse) {
    if (relmse.empty() || relmse.front().size() < 2) return {};
    const double whole = slope_without(relmse, relmse.size());
    if (!std::isfinite(whole)) return {};
    return jackknife_interval(whole, relmse.size(), [&](std::size_t s) { return slope_without(relmse, s); });
}

}  // namespace ctpbench
