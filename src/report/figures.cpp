#include "report/figures.h"

#include "wavefront/cuda_workload.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace ctpbench {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr Estimate kNone{kNaN, kNaN, kNaN};

// Null if there are none, or none that may be shown.
const std::vector<double>* samples_of(const CellResult* cell, std::string_view kernel,
                                      std::vector<double> KernelSeries::*quantity) {
    if (cell == nullptr || !cell->valid) return nullptr;
    const KernelSeries* series = cell->find(kernel);
    return series == nullptr || series->mrays.empty() ? nullptr : &(series->*quantity);
}

std::vector<double> paired_series(const std::vector<double>* a, const std::vector<double>* b) {
    return a == nullptr || b == nullptr ? std::vector<double>() : paired_ratios(*a, *b);
}

Estimate paired(const std::vector<double>* a, const std::vector<double>* b) {
    const std::vector<double> ratios = paired_series(a, b);
    return ratios.empty() ? kNone : estimate_median(ratios);
}

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

std::string_view main_kernel(const CellResult& cell) {
    return cell.contender.renders() ? "shade" : "intersect";
}

const CellResult* reference_of(const CellResult& cell, const Results& results, const std::string& reference) {
    Contender like = cell.contender;
    if (cell.contender.renders()) {
        like.shade = reference, like.offset = of_bundle, like.bounce_limit = 0, like.roulette = false;
    } else {
        const Axes axes = default_axes();
        like.strategy = reference, like.restart_carries_t = true;
        like.traversal = axes.traversal.front(), like.methods = axes.methods.front();
        like.triangle_test = like.sphere_test = like.box_test = of_bundle;
    }
    return results.find(cell.workload, like.label());
}

const CellResult* yardstick_of(const CellResult& cell, const Results& results) {
    // With as many threads of the CPU.
    if (cell.contender.backend == "cpu")
        return results.find(cell.workload, kYardstick + cell.contender.threads_part());
    return results.find(cell.workload, std::string(kCudaYardstick) + "/" + cell.contender.backend);
}

Estimate throughput_of(const CellResult* cell, std::string_view kernel) {
    const auto* samples = samples_of(cell, kernel, &KernelSeries::mrays);
    return samples == nullptr ? kNone : estimate_median(*samples);
}

Estimate seconds_of_kernel(const CellResult* cell, std::string_view kernel) {
    const auto* samples = samples_of(cell, kernel, &KernelSeries::seconds);
    return samples == nullptr ? kNone : estimate_median(*samples);
}

std::vector<double> ratios_of(const CellResult* a, const CellResult* b, std::string_view kernel) {
    return paired_series(samples_of(a, kernel, &KernelSeries::mrays),
                         samples_of(b, kernel, &KernelSeries::mrays));
}

Estimate ratio_of(const CellResult* a, const CellResult* b, std::string_view kernel) {
    return paired(samples_of(a, kernel, &KernelSeries::mrays), samples_of(b, kernel, &KernelSeries::mrays));
}

Estimate kernel_ratio_of(const CellResult* cell, std::string_view a, std::string_view b) {
    return paired(samples_of(cell, a, &KernelSeries::mrays), samples_of(cell, b, &KernelSeries::mrays));
}

Estimate seconds_ratio_of(const CellResult* cell, std::string_view a, std::string_view b) {
    return paired(samples_of(cell, a, &KernelSeries::seconds), samples_of(cell, b, &KernelSeries::seconds));
}

}  // namespace ctpbench
