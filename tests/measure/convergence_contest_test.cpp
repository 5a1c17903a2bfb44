// The contest of errors, on pipelines that make noise of a known kind in no time.
#include "measure/convergence_contest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "measure/error_slope.h"
#include "measure/noisy_images.h"

namespace ctpbench {
namespace {

using test::noisy_image;
using test::NoisyImage;
using test::relmse_of;

// A sample takes a second, and the copy nobody asked for three.
class NoisyPipeline final : public FramePipeline {
public:
    NoisyPipeline(std::uint64_t seed, double bias) : seed_(seed), bias_(bias) {}

    std::vector<StageTime> frame(bool, std::uint32_t sample, ImageStorage& image,
                                 const BounceObserver&) override {
        if (sample == 0) noisy_.emplace(seed_, 0.5, bias_);
        noisy_->add_samples(1);
        image = noisy_->image();
        return {{"intersect", 0, 900, 0.25},
                {"copy", 0, 900, 3.0},
                {"shade", 0, 900, 0.5},
                {"shade_matte", 0, 900, 9},
                {"blend", 0, 900, 0.25, 0, 2}};
    }

private:
    std::uint64_t seed_;
    double bias_;
    std::optional<NoisyImage> noisy_;
};

class ConvergenceContestTest : public testing::Test {
protected:
    ConvergenceContestTest() : reference_(noisy_image(1, 256), noisy_image(2, 256)) {}

    void enter(const std::string& pictures, double bias) {
        CellResult cell;
        cell.valid = true;
        cell.contender.backend = "cpu", cell.contender.strategy = pictures;
        cell.contender.traversal = "single", cell.contender.methods = "watertight";
        entrants_.push_back(
            {results_.cells.size(),
             [bias](std::uint64_t seed) { return std::make_unique<NoisyPipeline>(seed, bias); }, true,
             pictures});
        results_.cells.push_back(cell);
    }
    const Convergence& of(std::size_t cell) const { return results_.cells[cell].convergence; }

    ReferenceImage reference_;
    Results results_;
    std::vector<ConvergenceEntrant> entrants_;
    std::function<bool()> never_ = [] { return false; };
};

TEST_F(ConvergenceContestTest, FindsSlopesAndPlateaus) {
    enter("unbiased", 0.0);
    enter("biased", 0.1);
    enter("unbiased", 0.0);
    ConvergenceContest contest(reference_, 6, 10);
    for (std::uint32_t r = 0; r < 8; ++r) ASSERT_TRUE(contest.round(r, entrants_, results_, never_));
    contest.conclude(entrants_, results_);

    for (std::size_t cell = 0; cell < 3; ++cell) {
        ASSERT_EQ(of(cell).relmse.size(), 8u);
        EXPECT_EQ(of(cell).seconds[3], (std::vector<double>{1, 2, 4, 8, 16, 32, 64}));
        EXPECT_EQ(results_.cells[cell].samples, 64u);
        EXPECT_EQ(results_.cells[cell].clamped, 8u * 64u * 2u);
        EXPECT_EQ(results_.cells[cell].find("shade")->seconds, std::vector<double>(8, 32.0));
    }
    EXPECT_EQ(of(0).relmse, of(2).relmse);
    EXPECT_NE(of(0).relmse[0], of(0).relmse[1]);  // seeds are independent
    EXPECT_NEAR(of(0).relmse[0][0], relmse_of(0.25), 0.1 * relmse_of(0.25));
    EXPECT_NEAR(rmse_slope(of(0).relmse).value, -0.5, 0.03);
    EXPECT_GT(rmse_slope(of(1).relmse).lo, -0.47);

    EXPECT_LT(of(0).bias.lo, 0.0);
    EXPECT_GT(of(0).bias.hi, 0.0);
    EXPECT_LT(of(0).bias.hi, 0.05 * relmse_of(0.01));
    EXPECT_EQ(of(0).bias.value, of(2).bias.value);
    EXPECT_LT(of(1).bias.lo, relmse_of(0.01));
    EXPECT_GT(of(1).bias.hi, relmse_of(0.01));
    EXPECT_GT(of(1).bias.lo, 0.8 * relmse_of(0.01));
}

TEST_F(ConvergenceContestTest, RejectsPicturesThatShouldBeTheSame) {
    enter("same", 0.0);
    enter("same", 1e-3);
    enter("other", 1e-3);
    ConvergenceContest contest(reference_, 1, 10);
    for (std::uint32_t r = 0; r < 3; ++r) ASSERT_TRUE(contest.round(r, entrants_, results_, never_));
    contest.conclude(entrants_, results_);
    EXPECT_TRUE(results_.cells[0].valid);
    EXPECT_FALSE(results_.cells[1].valid);
    EXPECT_EQ(results_.cells[1].reason, "its picture of seed 10 differs from that of same");
    EXPECT_TRUE(results_.cells[2].valid);
    EXPECT_EQ(of(0).relmse.size(), 3u);
    EXPECT_EQ(of(1).relmse.size(), 1u);
    EXPECT_TRUE(std::isnan(of(1).bias.value));
}

TEST_F(ConvergenceContestTest, KeepsNothingOfARoundThatIsStopped) {
    enter("a", 0.0);
    enter("b", 0.1);
    ConvergenceContest contest(reference_, 2, 10);
    ASSERT_TRUE(contest.round(0, entrants_, results_, never_));
    int asked = 0;
    EXPECT_FALSE(contest.round(1, entrants_, results_, [&] { return ++asked > 7; }));  // within the second
    for (std::size_t cell = 0; cell < 2; ++cell) {
        EXPECT_EQ(of(cell).relmse.size(), 1u);
        EXPECT_EQ(results_.cells[cell].find("blend")->seconds.size(), 1u);
    }
    ASSERT_TRUE(contest.round(1, entrants_, results_, never_));
    contest.conclude(entrants_, results_);
    EXPECT_FALSE(std::isnan(of(1).bias.value));
}

}  // namespace
}  // namespace ctpbench
