// Offsets in whole frames: one change of policy changes rays alone, so every shade strategy shows the same
// image with each; and a convex body that reflects everything under even light shows which of them let a path
// hit what it just left.
#include <gtest/gtest.h>

#include "config/axes.h"
#include "wavefront/methods.h"
#include "wavefront/motley.h"
#include "wavefront/physics.h"

namespace ctpbench {
namespace {

using test::gray;

std::string key_with(const std::string& offset) {
    return intersect_methods("watertight", of_bundle, of_bundle, of_bundle, offset);
}

TEST(Offsets, AllShadeStrategiesShowTheSameImageWithEach) {
    const Scene scene = test::motley();
    std::set<std::uint64_t> images;
    for (const std::string& offset : offsets()) {
        test::Stage stage(scene, 2, "ctp", key_with(offset));
        std::uint64_t expected = 0;
        for (const std::string& shade : shade_strategies()) {
            const std::uint64_t image =
                test::render(stage, test::kMotleyCamera, {61, 43, 6, 9}, 2, shade, {}, offset).image.hash();
            if (expected == 0) expected = image;
            EXPECT_EQ(image, expected) << offset << ", " << shade;
        }
        images.insert(expected);
    }
    EXPECT_EQ(images.size(), offsets().size()) << "each offset makes other rays";
}

// The share of paths that meet the convex body again after they have left it, per thousand.
double hits_again(bool sphere, float scale, float shift, const std::string& offset) {
    Scene scene;
    test::add_material(scene, test::matte(gray(1.0f)));
    const Vec3 center = gray(shift);
    if (sphere)
        scene.spheres.push_back({center, scale});
    else
        test::add_mesh(scene, test::star(4, scale, center, 1, 0.0f), 0);
    test::Stage stage(scene, 2, "ctp", key_with(offset));
    double hits = 0.0, again = 0.0;
    const Camera camera = test::looking_from(center + 2.5f * scale * normalize({0.15f, 0.1f, 1.0f}), center);
    test::render(
        stage, camera, {128, 128, 1, 3}, 1, "ctp",
        [&](const BounceView& view) {
            for (const std::uint32_t slot : view.slots)
                if (view.hits.primitive[slot] != kNoPrimitive) ++(view.bounce == 0 ? hits : again);
        },
        offset);
    EXPECT_GT(hits, 3000.0);
    return 1000.0 * again / hits;
}

TEST(Offsets, OfWaechterAndBinderNeverLetsAPathHitWhatItLeft) {
    for (const bool sphere : {false, true})
        for (const auto& [scale, shift] : {std::pair{1.0f, 0.0f}, {1e3f, 0.0f}, {1e-3f, 0.0f}, {1.0f, 1e4f}})
            EXPECT_EQ(hits_again(sphere, scale, shift, "waechter_binder"), 0.0)
                << "sphere " << sphere << ", scale " << scale << ", shift " << shift;
}

// What the notes of the field say of the others: an absolute distance is sound at the scale that it was made
// for, and loses a third to a half of the paths at others.
TEST(Offsets, OfAConstantDistanceIsForOneScale) {
    for (const bool sphere : {false, true}) {
        EXPECT_LT(hits_again(sphere, 1.0f, 0.0f, "constant_epsilon"), 5.0);
        EXPECT_GT(hits_again(sphere, 1.0f, 1e4f, "constant_epsilon"), 200.0);
    }
}

// A share of the way scales, but is lost where coordinates are large beside it.
TEST(Offsets, OfAShareOfTheWayScalesWithTheScene) {
    for (const bool sphere : {false, true})
        for (const float scale : {1e-3f, 1.0f, 1e3f})
            EXPECT_LT(hits_again(sphere, scale, 0.0f, "relative_epsilon"), 1.0) << sphere << ", " << scale;
    for (const bool sphere : {false, true})
        EXPECT_GT(hits_again(sphere, 1.0f, 1e4f, "relative_epsilon"), 5.0);
}

// No triangle is hit again by a path that leaves it out, at any scale. Its neighbours may be, where
// coordinates are coarse. A sphere is left out as a whole, which for a convex body is right from outside.
TEST(Offsets, ExcludingTheTriangleMendsAllButItsNeighbours) {
    for (const auto& [scale, shift] : {std::pair{1.0f, 0.0f}, {1e3f, 0.0f}, {1e-3f, 0.0f}})
        EXPECT_LT(hits_again(false, scale, shift, "exclude_id"), 1.0) << scale;
    const double neighbours = hits_again(false, 1.0f, 1e4f, "exclude_id");
    EXPECT_GT(neighbours, 1.0);
    EXPECT_LT(neighbours, 100.0);
}

}  // namespace
}  // namespace ctpbench
