#include "report/figures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace ctpbench {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::string fixed(double value, int digits) {
    if (std::isnan(value)) return "n/a";
    char text[40];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

std::string with_interval(const Estimate& e) {
    return std::isnan(e.median) ? "n/a"
                                : fixed(e.median, 2) + " [" + fixed(e.lo, 2) + ", " + fixed(e.hi, 2) + "]";
}

Estimate throughput_of(const CellResult* cell) {
    if (cell == nullptr || !cell->valid || cell->mrays.empty()) return {kNaN, kNaN, kNaN};
    return estimate_median(cell->mrays);
}

Estimate ratio_of(const CellResult* a, const CellResult* b) {
    if (a == nullptr || b == nullptr || !a->valid || !b->valid) return {kNaN, kNaN, kNaN};
    const std::size_t rounds = std::min(a->mrays.size(), b->mrays.size());
    if (rounds == 0) return {kNaN, kNaN, kNaN};
    return estimate_paired_ratio({a->mrays.begin(), a->mrays.begin() + static_cast<std::ptrdiff_t>(rounds)},
                                 {b->mrays.begin(), b->mrays.begin() + static_cast<std::ptrdiff_t>(rounds)});
}

}  // namespace ctpbench
