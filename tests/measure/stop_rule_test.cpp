#include "measure/stop_rule.h"

#include <gtest/gtest.h>

namespace ctpbench {
namespace {

constexpr std::uint32_t most = 100;

std::string reason(const StopRule& rule, std::uint32_t done, double seconds, double noise) {
    return rule.reason(done, seconds, most, [&] { return noise; });
}

TEST(StopRule, RoundsAlone) {
    const StopRule rule{9};
    EXPECT_EQ(reason(rule, 8, 1e6, 0.0), "");
    EXPECT_EQ(reason(rule, 9, 0.0, 1.0), "rounds");
}

TEST(StopRule, AllThatIsAskedForMustBeMet) {
    const StopRule rule{9, 2.0, 0.01, 30.0};
    EXPECT_EQ(reason(rule, 8, 3.0, 0.001), "");
    EXPECT_EQ(reason(rule, 9, 1.9, 0.001), "");
    EXPECT_EQ(reason(rule, 9, 2.0, 0.02), "");
    EXPECT_EQ(reason(rule, 9, 2.0, 0.01), "max_noise");
    EXPECT_EQ(reason({9, 2.0}, 9, 2.0, 1.0), "min_time");
}

TEST(StopRule, TimeRunsOutWhateverIsMissing) {
    const StopRule rule{9, 2.0, 0.01, 30.0};
    EXPECT_EQ(reason(rule, 1, 30.0, 1.0), "timeout");
    EXPECT_EQ(reason(rule, 20, 30.0, 0.001), "max_noise");
    EXPECT_EQ(reason(rule, most, 29.0, 1.0), "max_rounds");
}

TEST(StopRule, NoiseIsAskedForLast) {
    const StopRule rule{9, 2.0, 0.01, 30.0};
    const auto never = []() -> double {
        ADD_FAILURE() << "noise takes time to tell";
        return 0.0;
    };
    EXPECT_EQ(rule.reason(8, 3.0, most, never), "");
    EXPECT_EQ(rule.reason(9, 1.0, most, never), "");
    EXPECT_EQ((StopRule{9}.reason(9, 1.0, most, never)), "rounds");
}

TEST(StopRule, ProgressIsThatOfTheSlowestDemand) {
    EXPECT_DOUBLE_EQ((StopRule{10}.done(5, 100.0)), 0.5);
    EXPECT_DOUBLE_EQ((StopRule{10, 8.0}.done(9, 2.0)), 0.25);
    EXPECT_DOUBLE_EQ((StopRule{10, 8.0}.done(50, 9.0)), 1.0);
}

}  // namespace
}  // namespace ctpbench
