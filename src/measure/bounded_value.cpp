#include "measure/bounded_value.h"

#include <cmath>

namespace ctpbench {
namespace {

double mean_of(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double v : values) sum += v;
    return sum / static_cast<double>(values.size());
}

double squares_about(const std::vector<double>& values, double center) {
    double sum = 0.0;
    for (const double v : values) sum += (v - center) * (v - center);
    return sum;
}

BoundedValue about(double value, double standard_error, std::size_t items) {
    const double half = student_t(items - 1) * standard_error;
    return {value, value - half, value + half};
}

}  // namespace

double student_t(std::size_t degrees) {
    constexpr double z = 1.959963984540054;  // of the normal distribution
    const double n = static_cast<double>(degrees), z2 = z * z;
    const double first = z * (z2 + 1.0) / 4.0;
    const double second = z * (5.0 * z2 * z2 + 16.0 * z2 + 3.0) / 96.0;
    const double third = z * (3.0 * z2 * z2 * z2 + 19.0 * z2 * z2 + 17.0 * z2 - 15.0) / 384.0;
    return z + (first + (second + third / n) / n) / n;
}

BoundedValue mean_interval(const std::vector<double>& values) {
    if (values.empty()) return {};
    const double n = static_cast<double>(values.size()), mean = mean_of(values);
    BoundedValue interval;
    interval.value = mean;
    if (values.size() < kFewestValues) return interval;
    return about(mean, std::sqrt(squares_about(values, mean) / (n - 1.0) / n), values.size());
}

BoundedValue jackknife_interval(double whole, std::size_t items,
                                const std::function<double(std::size_t)>& without) {
    BoundedValue interval;
    interval.value = whole;
    if (items < kFewestValues) return interval;
    std::vector<double> values(items);
    for (std::size_t i = 0; i < items; ++i) values[i] = without(i);
    const double n = static_cast<double>(items);
    return about(whole, std::sqrt((n - 1.0) / n * squares_about(values, mean_of(values))), items);
}

}  // namespace ctpbench
