#include "measure/median_distribution.h"

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>

namespace ctpbench {
namespace {

// Of `n` draws with replacement from n ranks, the probability that the k-th smallest has at most rank r.
double order_statistic_up_to(std::size_t n, std::size_t k, std::size_t r) {
    if (r == 0) return 0.0;
    if (r >= n) return 1.0;
    const double p = static_cast<double>(r) / static_cast<double>(n);
    return boost::math::ibeta(static_cast<double>(k), static_cast<double>(n - k + 1), p);
}

// Of n = 2 h draws, the probability that the h-th smallest has at most rank r and the next more than rank s;
// r <= s. Then h draws are among the first r ranks and the others beyond s.
double parted(std::size_t n, std::size_t r, std::size_t s) {
    const double h = static_cast<double>(n / 2), size = static_cast<double>(n);
    if (r == 0 || s == n) return 0.0;
    return std::exp(
        std::lgamma(size + 1.0) - 2.0 * std::lgamma(h + 1.0) +
        h * (std::log(static_cast<double>(r) / size) + std::log(static_cast<double>(n - s) / size)));
}

}  // namespace

MedianDistribution::MedianDistribution(std::vector<double> x) {
    std::sort(x.begin(), x.end());
    const std::size_t n = x.size(), h = n / 2;
    // The median's rank has a standard deviation below sqrt(n) / 2; nine of them from the middle lies no
    // probability that a double could tell.
    const auto reach = static_cast<std::size_t>(4.5 * std::sqrt(static_cast<double>(n))) + 2;
    const std::size_t first = h > reach ? h - reach : 0, last = std::min(n, h + reach);
    if (n % 2 == 1) {
        for (std::size_t i = first; i < last; ++i)
            atoms_.push_back(
                {x[i], order_statistic_up_to(n, h + 1, i + 1) - order_statistic_up_to(n, h + 1, i)});
        return;
    }
    for (std::size_t i = first; i < last; ++i) {
        double both = order_statistic_up_to(n, h, i + 1) - order_statistic_up_to(n, h, i);
        // The lower middle value has rank i + 1; what is beyond the window counts as its last.
        for (std::size_t j = i + 1; j < last; ++j) {
            const double p =
                parted(n, i + 1, j) - parted(n, i, j) - parted(n, i + 1, j + 1) + parted(n, i, j + 1);
            atoms_.push_back({0.5 * (x[i] + x[j]), std::max(p, 0.0)});
            both -= p;
        }
        atoms_.push_back({x[i], std::max(both, 0.0)});
    }
    sort();
}

MedianDistribution::MedianDistribution(const std::vector<std::vector<double>>& runs) {
    const double n = static_cast<double>(runs.size());
    for (const std::vector<double>& run : runs) {
        const MedianDistribution of_run(run);
        for (const Atom& a : of_run.atoms()) atoms_.push_back({a.value, a.probability / n});
    }
    sort();
    // A draw is now one run's median; the middle one of n draws is at most x if half of them or more are.
    const double middle = 0.5 * (n + 1.0);
    double sum = 0.0, before = 0.0;
    for (Atom& a : atoms_) {
        sum += a.probability;
        const double up_to = boost::math::ibeta(middle, middle, std::clamp(sum, 0.0, 1.0));
        a.probability = up_to - before, before = up_to;
    }
}

void MedianDistribution::sort() {
    std::sort(atoms_.begin(), atoms_.end(), [](const Atom& a, const Atom& b) { return a.value < b.value; });
}

double MedianDistribution::quantile(double share) const {
    double sum = 0.0;
    for (const Atom& a : atoms_) {
        sum += a.probability;
        if (sum >= share) return a.value;
    }
    return atoms_.back().value;
}

double RatioDistribution::below(double ratio, bool inclusive) const {
    double probability = 0.0, sum = 0.0;
    auto a = a_.atoms().begin();
    for (const auto& b : b_.atoms()) {
        const double limit = ratio * b.value;
        while (a != a_.atoms().end() && (inclusive ? a->value <= limit : a->value < limit))
            sum += a++->probability;
        probability += b.probability * sum;
    }
    return probability;
}

double RatioDistribution::quantile(double share) const {
    double lo = a_.atoms().front().value / b_.atoms().back().value;
    double hi = a_.atoms().back().value / b_.atoms().front().value;
    for (int i = 0; i < 60 && lo < hi; ++i) {
        const double middle = std::sqrt(lo * hi);
        (up_to(middle) >= share ? hi : lo) = middle;
    }
    return hi;
}

}  // namespace ctpbench
