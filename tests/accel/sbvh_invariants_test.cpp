#include <gtest/gtest.h>

#include "tests/accel/check_tree.h"
#include "tests/accel/soups.h"

namespace ctpbench::test {
namespace {

SbvhSettings single_types() {
    SbvhSettings s = SbvhSettings::quality();
    s.single_type_leaves = true;
    return s;
}

struct Case {
    const char* name;
    SbvhSettings settings;
};

class SbvhInvariants : public testing::TestWithParam<Case> {};

TEST_P(SbvhInvariants, NeedlesAreSplitAndCovered) {
    const Tree tree = build_and_check(needles(600, {0, 0, 0}, 1, 1), GetParam().settings);
    EXPECT_GT(tree.refs.size(), 700u) << "spatial splits are expected here";
}

TEST_P(SbvhInvariants, NeedlesFarFromTheOrigin) {
    build_and_check(needles(400, {1e4f, -1e4f, 3e4f}, 1, 2), GetParam().settings);
}

TEST_P(SbvhInvariants, MixedTypes) {
    Scene scene = needles(300, {0, 0, 0}, 1, 3);
    add_spheres(scene, 300, {0, 0, 0}, 1, 0.1f, 4);
    build_and_check(scene, GetParam().settings);
    build_and_check(scene, GetParam().settings, 12, PrimitiveSet::triangles);
    build_and_check(scene, GetParam().settings, 12, PrimitiveSet::spheres);
}

TEST_P(SbvhInvariants, TheBudgetBinds) {
    SbvhSettings settings = GetParam().settings;
    const Scene scene = needles(500, {0, 0, 0}, 1, 5);
    for (const float budget : {1.0f, 1.1f, 1.5f}) {
        settings.reference_budget = budget;
        const Tree tree = build_and_check(scene, settings);
        if (budget == 1.0f) {
            EXPECT_EQ(tree.refs.size(), 500u);
        }
        if (budget == 1.5f) {
            EXPECT_GT(tree.refs.size(), 600u) << "a share of the budget lies unused";
        }
    }
}

TEST_P(SbvhInvariants, FewPrimitives) {
    for (std::size_t n = 1; n < 12; ++n) build_and_check(needles(n, {0, 0, 0}, 1, 6), GetParam().settings);
}

INSTANTIATE_TEST_SUITE_P(Settings, SbvhInvariants,
                         testing::Values(Case{"quality", SbvhSettings::quality()},
                                         Case{"paper", SbvhSettings::paper()},
                                         Case{"single_types", single_types()}),
                         [](const auto& info) { return info.param.name; });

TEST(Sbvh, NoPrimitivesGiveAnEmptyTree) {
    const Tree tree = build_sbvh(ScenePrimitives(Scene{}), SbvhSettings::quality());
    EXPECT_TRUE(tree.empty());
    EXPECT_TRUE(tree.nodes.empty());
    EXPECT_EQ(tree.depth, 0u);
    EXPECT_EQ(tree.sah, 0.0f);
}

TEST(Sbvh, SpatialSplitsLowerTheCost) {
    const Scene scene = needles(2000, {0, 0, 0}, 1, 7);
    SbvhSettings without = SbvhSettings::quality();
    without.alpha = 1.0f;
    const Tree plain = build_sbvh(ScenePrimitives(scene), without);
    const Tree split = build_sbvh(ScenePrimitives(scene), SbvhSettings::quality());
    EXPECT_EQ(plain.refs.size(), 2000u);
    EXPECT_LT(split.sah, 0.5f * plain.sah);
}

// The paper's spheres-only trees have 0.675 to 0.683 nodes per sphere (Table 2).
TEST(Sbvh, PaperSettingsReproduceTheNodeCountOfItsSpheres) {
    Scene scene;
    add_spheres(scene, 10000, {0, 0, 0}, 1, 0.001f, 8);
    const Tree tree = build_sbvh(ScenePrimitives(scene), SbvhSettings::paper());
    EXPECT_NEAR(tree.node_count() / 10000.0, 0.678, 0.02);
}

TEST(Sbvh, ProgressNeverGoesBackAndEndsAtOne) {
    const Scene scene = needles(20000, {0, 0, 0}, 1, 9);
    std::vector<double> fractions;
    const Tree with = build_sbvh(ScenePrimitives(scene), SbvhSettings::quality(),
                                 [&](double fraction) { fractions.push_back(fraction); });
    ASSERT_GE(fractions.size(), 2u);
    EXPECT_EQ(fractions.front(), 0.0);
    EXPECT_EQ(fractions.back(), 1.0);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_GE(fractions.size(), static_cast<std::size_t>(with.build_seconds / 0.5));
}

}  // namespace
}  // namespace ctpbench::test
