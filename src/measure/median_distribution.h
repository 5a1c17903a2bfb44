// The bootstrap distribution of a median, exactly: every value that the median of a resample can have, and
// how probable it is. Nothing is drawn, so equal samples give equal intervals, and the tails are true as far
// out as a correction for many comparisons asks for. Maritz & Jarrett, "A Note on Estimating the Variance of
// the Sample Median", J. Am. Stat. Assoc. 73(361), 1978; Hutson & Ernst, "The exact bootstrap mean and
// variance of an L-estimator", J. R. Stat. Soc. B 62(1), 2000.
//
// The hazard: the samples count as independent draws from one distribution. Rounds of one process are not
// draws from all processes, for which there is a second constructor, and rounds that drift are not
// independent.
#pragma once

#include <cstddef>
#include <vector>

namespace ctpbench {

class MedianDistribution {
public:
    // `samples` must not be empty.
    explicit MedianDistribution(std::vector<double> samples);
    // The median over runs of their medians: as many runs are drawn as there are, with replacement, and
    // rounds of each. What processes differ by is then in it, as far as so many processes tell. Neither
    // `runs` nor any of them may be empty. With an even number of runs the distribution lies between those of
    // the two middle ones.
    explicit MedianDistribution(const std::vector<std::vector<double>>& runs);

    struct Atom {
        double value, probability;
    };
    // Values ascend; one may be there more than once.
    const std::vector<Atom>& atoms() const& { return atoms_; }
    const std::vector<Atom>& atoms() const&& = delete;  // a loop over a temporary's would dangle

    // The smallest value that is not exceeded with at least this probability.
    double quantile(double share) const;

private:
    void sort();
    std::vector<Atom> atoms_;
};

// The quotient a / b of two medians, each resampled by itself: of two runs, whose rounds are no pairs. All
// values must be positive.
class RatioDistribution {
public:
    RatioDistribution(const MedianDistribution& a, const MedianDistribution& b) : a_(a), b_(b) {}
    // Probability of at most, or of less than, this quotient.
    double up_to(double ratio) const { return below(ratio, true); }
    double below(double ratio) const { return below(ratio, false); }
    double quantile(double share) const;

private:
    double below(double ratio, bool inclusive) const;

    const MedianDistribution& a_;
    const MedianDistribution& b_;
};

}  // namespace ctpbench
