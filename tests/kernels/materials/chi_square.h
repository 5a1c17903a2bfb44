// Pearson's test of whether counts come from expected ones.
#pragma once

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <vector>

namespace ctpbench::test {

struct ChiSquare {
    double statistic;
    std::size_t cells;  // that were left to compare
    double p_value;     // how often counts that are right deviate as much
};

// The statistic is distributed as it should be only if no cell expects too few: such cells are pooled, and if
// even the pool expects too few it joins the smallest of the others.
inline ChiSquare chi_square(const std::vector<double>& observed, const std::vector<double>& expected) {
    constexpr double fewest = 5.0;
    struct Cell {
        double expected, observed;
    };
    std::vector<Cell> cells;
    Cell pool{0.0, 0.0};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        if (expected[i] >= fewest) {
            cells.push_back({expected[i], observed[i]});
        } else {
            pool.expected += expected[i], pool.observed += observed[i];
        }
    }
    if (pool.expected >= fewest || cells.empty()) {
        cells.push_back(pool);
    } else {
        Cell& least = *std::min_element(cells.begin(), cells.end(),
                                        [](const Cell& a, const Cell& b) { return a.expected < b.expected; });
        least.expected += pool.expected, least.observed += pool.observed;
    }
    double statistic = 0.0;
    for (const Cell& c : cells)
        statistic += (c.observed - c.expected) * (c.observed - c.expected) / c.expected;
    if (cells.size() < 2) return {statistic, cells.size(), 0.0};  // nothing was tested
    const boost::math::chi_squared distribution(static_cast<double>(cells.size() - 1));
    return {statistic, cells.size(), boost::math::cdf(boost::math::complement(distribution, statistic))};
}

}  // namespace ctpbench::test
