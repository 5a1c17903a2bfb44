// A value with a 95 % interval, from values that are independent of each other.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace ctpbench {

// All NaN where there are too few values to tell.
struct BoundedValue {
    double value = std::numeric_limits<double>::quiet_NaN();
    double lo = std::numeric_limits<double>::quiet_NaN();
    double hi = std::numeric_limits<double>::quiet_NaN();
};

// Below this many values their scatter says too little about itself.
inline constexpr std::size_t kFewestValues = 4;

// The 97.5 % quantile of Student's t with this many degrees of freedom, by the expansion about the normal's
// (Abramowitz and Stegun, Handbook of Mathematical Functions, 1964, 26.7.5); within 1 % from 3 on.
double student_t(std::size_t degrees);

// The mean with Student's interval. With fewer than kFewestValues values it has no bounds; with none it is
// NaN.
BoundedValue mean_interval(const std::vector<double>& values);

// A statistic of n independent items that is no plain mean, by the jackknife (Efron and Tibshirani, An
// Introduction to the Bootstrap, 1993, ch. 11): `without(i)` is the statistic with item i left out, `whole`
// that of all. It has no bounds where there are fewer than kFewestValues items.
BoundedValue jackknife_interval(double whole, std::size_t items,
                                const std::function<double(std::size_t)>& without);

}  // namespace ctpbench
