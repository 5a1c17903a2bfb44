#include "base/suggest.h"

#include <gtest/gtest.h>

namespace ctpbench {
namespace {

const std::vector<std::string> strategies = {"ctp", "std_variant", "oop", "oop_arena", "restart"};

TEST(Suggest, FindsTheNameOneSlipAway) {
    EXPECT_EQ(nearest_name("cpt", strategies), "ctp");  // swapped
    EXPECT_EQ(nearest_name("restrat", strategies), "restart");
    EXPECT_EQ(nearest_name("opp", strategies), "oop");  // replaced
    EXPECT_EQ(nearest_name("op", strategies), "oop");   // left out
    EXPECT_EQ(nearest_name("oop-arena", strategies), "oop_arena");
    EXPECT_EQ(nearest_name("CTP", strategies), "ctp");
    EXPECT_EQ(nearest_name("std_varaint", strategies), "std_variant");
}

TEST(Suggest, StaysSilentWhenNothingIsNear) {
    EXPECT_EQ(nearest_name("embree", strategies), std::nullopt);
    EXPECT_EQ(nearest_name("", strategies), std::nullopt);
    EXPECT_EQ(nearest_name("x", {"y"}), std::nullopt);
    EXPECT_EQ(nearest_name("ctp", {}), std::nullopt);
    EXPECT_EQ(nearest_name(std::string(100'000, 'a'), strategies), std::nullopt);
}

TEST(Suggest, PrefersTheNearerAndThenTheFirst) {
    EXPECT_EQ(nearest_name("table", {"table22", "table2", "table3"}), "table2");
}

TEST(Suggest, UnknownNameListsTheChoices) {
    EXPECT_EQ(unknown_name("strategy", "cpt", {"ctp", "oop"}),
              "unknown strategy \"cpt\"; did you mean \"ctp\"? choices: \"ctp\", \"oop\"");
    EXPECT_EQ(unknown_name("strategy", "zzz", {"ctp", "oop"}),
              "unknown strategy \"zzz\"; choices: \"ctp\", \"oop\"");
    EXPECT_EQ(unknown_name("scene", "zzz", {}), "unknown scene \"zzz\"");
}

}  // namespace
}  // namespace ctpbench
