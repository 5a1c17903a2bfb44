// Which methods go together, and that all that do trace.
#include <gtest/gtest.h>

#include <algorithm>

#include "config/axes.h"
#include "support.h"
#include "wavefront/frames.h"
#include "wavefront/methods.h"

namespace ctpbench {
namespace {

std::string obstacle(const std::string& strategy, const std::string& bundle, const std::string& triangle,
                     const std::string& sphere, const std::string& box,
                     const std::string& offset = of_bundle) {
    return methods_obstacle(strategy, bundle, triangle, sphere, box, offset);
}

TEST(Methods, BundlesNameTheirParts) {
    const auto bundles = method_bundles();
    ASSERT_EQ(bundles.front().name, "watertight");
    for (const MethodsInfo& m : bundles) {
        const auto has = [](const std::vector<std::string>& names, const std::string& name) {
            return std::find(names.begin(), names.end(), name) != names.end();
        };
        EXPECT_TRUE(has(triangle_tests(), m.triangle_test)) << m.name;
        EXPECT_TRUE(has(sphere_tests(), m.sphere_test)) << m.name;
        EXPECT_TRUE(has(box_tests(), m.box_test)) << m.name;
        EXPECT_TRUE(has(offsets(), m.offset)) << m.name;
        EXPECT_EQ(methods_exact(m.name), m.exact);
        EXPECT_EQ(m.exact, m.name == "watertight") << m.name;
        EXPECT_EQ(offset_of(m.name, of_bundle), m.offset);
    }
}

TEST(Methods, KeysNameTheBundleWithTheseTestsElseTheTests) {
    const auto key = [](const std::string& bundle, const std::string& triangle, const std::string& sphere,
                        const std::string& box, const std::string& offset = of_bundle) {
        return intersect_methods(bundle, triangle, sphere, box, offset);
    };
    EXPECT_EQ(key("paper", of_bundle, of_bundle, of_bundle), "paper");
    EXPECT_EQ(key("watertight", "pluecker", of_bundle, of_bundle), "pluecker+stable+padded");
    EXPECT_EQ(key("paper", "woop", "stable", "padded"), "watertight");
    EXPECT_EQ(key("watertight", of_bundle, of_bundle, of_bundle, "constant_epsilon"), "watertight");
    EXPECT_EQ(key("watertight", of_bundle, of_bundle, of_bundle, "exclude_id"), "watertight+exclude_id");
    EXPECT_TRUE(methods_exact("watertight+exclude_id"));
    EXPECT_TRUE(methods_exact("woop+stable_f64+padded"));
    EXPECT_FALSE(methods_exact("woop+textbook+padded"));
    EXPECT_FALSE(methods_exact("pluecker+stable+padded"));
    EXPECT_FALSE(methods_exact("own"));
}

TEST(Methods, WhatIsNotBuiltIsRefusedWithAReason) {
    EXPECT_EQ(obstacle("restart", "float64", of_bundle, of_bundle, of_bundle), "");
    EXPECT_EQ(obstacle("restart", "paper", of_bundle, of_bundle, of_bundle, "relative_epsilon"), "");
    EXPECT_NE(obstacle("restart", "watertight", "pluecker", of_bundle, of_bundle).find("\"ctp\""),
              std::string::npos);
    EXPECT_NE(obstacle("ctp", "watertight", "pluecker", "textbook", of_bundle).find("not built together"),
              std::string::npos);
    EXPECT_EQ(obstacle("ctp", "watertight", of_bundle, of_bundle, of_bundle, "exclude_id"), "");
    EXPECT_NE(obstacle("oop", "watertight", of_bundle, of_bundle, of_bundle, "exclude_id").find("\"ctp\""),
              std::string::npos);
    EXPECT_NE(obstacle("ctp", "paper", of_bundle, of_bundle, of_bundle, "exclude_id").find("\"watertight\""),
              std::string::npos);
    EXPECT_NE(
        obstacle("ctp", "watertight", "plucker", of_bundle, of_bundle).find("did you mean \"pluecker\""),
        std::string::npos);
    EXPECT_NE(obstacle("ctp", "watertigt", of_bundle, of_bundle, of_bundle).find("\"watertight\""),
              std::string::npos);
}

// Of all that could be asked for: 15 of triangles and boxes, 2 more of spheres, less the bundles' own, for
// `ctp`; for every other strategy the bundles. Each traces, and finds what the default does but on a few
// rays.
TEST(Methods, AllWithoutObstacleTrace) {
    const Scene scene = test::soup(600, 200, 17);
    test::Stage stage(scene, 2);
    const LayoutInput input = stage.forest.layout_input(stage.view.geometry());
    constexpr std::uint32_t rays = 4000;
    RayStorage storage;
    storage.resize(rays);
    test::Random random(5);
    std::vector<std::uint32_t> index(rays);
    for (std::uint32_t i = 0; i < rays; ++i) {
        storage.view().store(i, {random.point(-2, 2), random.direction(), test::kInfinity});
        index[i] = i;
    }
    const auto trace = [&](const Intersector& intersector) {
        HitStorage hits;
        hits.resize(rays);
        intersector.intersect(stage.backend,
                              {storage.view(), hits.view(), index.data(), rays, stage.view.geometry().extent},
                              true);
        return hits;
    };
    HitStorage expected = trace(*stage.intersector);
    std::size_t for_ctp = 0, for_restart = 0;
    for (const std::string& triangle : triangle_tests())
        for (const std::string& sphere : sphere_tests())
            for (const std::string& box : box_tests()) {
                for_restart += obstacle("restart", "watertight", triangle, sphere, box).empty();
                if (!obstacle("ctp", "watertight", triangle, sphere, box).empty()) continue;
                ++for_ctp;
                const std::string key = intersect_methods("watertight", triangle, sphere, box, of_bundle);
                HitStorage hits = trace(*make_intersector("ctp", key, input));
                std::uint32_t different = 0;
                for (std::uint32_t i = 0; i < rays; ++i)
                    different += hits.view().primitive[i] != expected.view().primitive[i];
                EXPECT_LT(different, rays / 200) << key;
                const bool same =
                    key == "watertight" || key == "woop+stable+ize" || key == "woop+stable+plain";
                EXPECT_TRUE(same || hits.hash() != expected.hash()) << key << ": arithmetic differs";
            }
    EXPECT_EQ(for_restart, method_bundles().size());
    EXPECT_EQ(for_ctp, 15u + 2u + 2u) << "the tests of `paper` and `float64` are not among the exchanges";
}

}  // namespace
}  // namespace ctpbench
