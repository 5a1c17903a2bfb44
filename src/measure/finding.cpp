#include "measure/finding.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ctpbench {
namespace {

// A difference may be to either side, so each counts half of the error; sameness is two tests of which both
// must hold.
Claims claims(const RatioDistribution& ratio, double band, std::size_t rounds, double least) {
    Claims c;
    c.rounds = rounds;
    if (rounds < kLeastRounds) return c;
    const auto p = [&](double probability) { return std::clamp(probability, least, 1.0); };
    c.slower = std::min(1.0, 2.0 * p(1.0 - ratio.below(band)));
    c.faster = std::min(1.0, 2.0 * p(ratio.up_to(1.0 / band)));
    c.same = std::max(p(ratio.up_to(band)), p(1.0 - ratio.below(1.0 / band)));
    return c;
}

}  // namespace

double least_p(std::size_t rounds) { return std::exp2(-static_cast<double>(rounds)); }

double least_p(std::size_t rounds, std::size_t other_rounds) {
    const double a = static_cast<double>(rounds), b = static_cast<double>(other_rounds);
    return std::exp(std::lgamma(a + 1.0) + std::lgamma(b + 1.0) - std::lgamma(a + b + 1.0));
}

const char* name_of(Finding finding) {
    switch (finding) {
        case Finding::same:
            return "SAME";
        case Finding::faster:
            return "FASTER";
        case Finding::slower:
            return "SLOWER";
        case Finding::unclear:
            break;
    }
    return "UNCLEAR";
}

Claims claims_of(const RatioDistribution& ratio, std::size_t rounds, std::size_t other_rounds) {
    return claims(ratio, kRunBand, std::min(rounds, other_rounds), least_p(rounds, other_rounds));
}

Claims claims_of(const std::vector<double>& ratios) {
    if (ratios.empty()) return {};
    const MedianDistribution median(ratios), one(std::vector<double>{1.0});
    return claims(RatioDistribution(median, one), kBand, ratios.size(), least_p(ratios.size()));
}

double claim_below(const RatioDistribution& ratio, double limit, std::size_t rounds,
                   std::size_t other_rounds) {
    if (std::min(rounds, other_rounds) < kLeastRounds) return 1.0;
    return std::min(1.0, 2.0 * std::max(1.0 - ratio.below(limit), least_p(rounds, other_rounds)));
}

std::size_t rounds_for(std::size_t comparisons) {
    std::size_t rounds = kLeastRounds;
    while (2.0 * least_p(rounds) * static_cast<double>(comparisons) > kError) ++rounds;
    return rounds;
}

std::vector<double> holm(const std::vector<double>& p) {
    std::vector<std::size_t> order(p.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
    std::vector<double> adjusted(p.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        largest = std::max(largest, std::min(1.0, static_cast<double>(p.size() - i) * p[order[i]]));
        adjusted[order[i]] = largest;
    }
    return adjusted;
}

std::vector<Finding> findings(const std::vector<Claims>& comparisons) {
    std::vector<Finding> best(comparisons.size(), Finding::unclear);
    std::vector<std::size_t> tested;
    std::vector<double> p;
    for (std::size_t i = 0; i < comparisons.size(); ++i) {
        const Claims& c = comparisons[i];
        if (c.rounds < kLeastRounds) continue;
        tested.push_back(i), p.push_back(std::min({c.same, c.faster, c.slower}));
        best[i] = p.back() == c.same     ? Finding::same
                  : p.back() == c.faster ? Finding::faster
                                         : Finding::slower;
    }
    const std::vector<double> adjusted = holm(p);
    for (std::size_t i = 0; i < tested.size(); ++i)
        if (adjusted[i] > kError) best[tested[i]] = Finding::unclear;
    return best;
}

}  // namespace ctpbench
