// What a ratio of speeds says: SAME, FASTER, SLOWER, or UNCLEAR where the rounds do not tell. Every claim is
// tested, and the claims of one table are tested together (Holm, "A Simple Sequentially Rejective Multiple
// Test Procedure", Scand. J. Stat. 6(2), 1979), so that a wrong one among all of them has a chance of 5 %.
//
// The hazard: rounds of one process tell nothing of the next process, whose memory lies elsewhere. The band
// of two runs is wider for that: what two processes of one binary differ by must not be called a difference.
#pragma once

#include <cstddef>
#include <vector>

#include "measure/median_distribution.h"

namespace ctpbench {

// Ratios from the band to 1 / band are the same speed: within the rounds of one run, and of two runs.
inline constexpr double kBand = 0.95;
inline constexpr double kRunBand = 0.93;
// No verdict rests on fewer rounds.
inline constexpr std::size_t kLeastRounds = 9;
inline constexpr double kError = 0.05;

enum class Finding { unclear, same, faster, slower };
const char* name_of(Finding finding);

// Probabilities of what would make a claim wrong: p-values.
struct Claims {
    std::size_t rounds = 0;  // of the side that has fewer
    double same = 1.0, faster = 1.0, slower = 1.0;
};

// How little rounds can leave to chance, whatever a resampling of them says: that all of n ratios fall on one
// side of a limit happens in 2^-n; that all rounds of one run are beyond all of another, in one of the orders
// of both.
double least_p(std::size_t rounds);
double least_p(std::size_t rounds, std::size_t other_rounds);

// Of the ratio of two runs; of ratios within the rounds of one run. Fewer than kLeastRounds support no claim.
Claims claims_of(const RatioDistribution& ratio, std::size_t rounds, std::size_t other_rounds);
Claims claims_of(const std::vector<double>& ratios);

// The p-value of the claim that the ratio of two runs is below `limit`.
double claim_below(const RatioDistribution& ratio, double limit, std::size_t rounds,
                   std::size_t other_rounds);

// How many rounds of one run can support a difference in each of so many comparisons.
std::size_t rounds_for(std::size_t comparisons);

// Holm's adjusted p-values, in the order given.
std::vector<double> holm(const std::vector<double>& p);

// Of each comparison the claim that is best supported, if it stands among all of them. Those with too few
// rounds are unclear, and do not count among the others.
std::vector<Finding> findings(const std::vector<Claims>& comparisons);

}  // namespace ctpbench
