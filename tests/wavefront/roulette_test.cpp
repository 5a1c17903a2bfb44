// Russian roulette leaves means alone, ends paths, and is not there when it is off.
#include <gtest/gtest.h>

#include "wavefront/motley.h"
#include "wavefront/physics.h"

namespace ctpbench {
namespace {

using test::gray;

// Inside a closed body of albedo rho under its own light E: the radiance is E / (1 - rho), less what the
// paths that are cut off would have brought, rho^(bounces + 1) of it. Here a lamp fills part of a room
// instead, and both images are estimates of the same.
Scene room(float albedo) {
    Scene scene;
    const std::uint32_t walls = test::add_material(scene, test::matte(gray(albedo)));
    test::add_mesh(scene, test::star(3, 1.0f, {0, 0, 0}, 3), walls);
    const std::uint32_t lamp = test::add_material(scene, test::emissive(gray(2.0f)));
    test::add_square(scene, 0.3f, 0.3f, lamp);
    scene.ambient = gray(0.0f);
    return scene;
}

std::uint64_t shaded(const test::Frames& frames) {
    std::uint64_t sum = 0;
    for (const StageTime& s : frames.stages)
        if (std::string(s.kernel) == "shade") sum += s.rays;
    return sum;
}

TEST(Roulette, LeavesTheMeanAndShortensPaths) {
    const Camera camera = test::looking_from({0.1f, 0.2f, -0.4f}, {0, 0, 0.5f});
    for (const float albedo : {0.5f, 0.9f}) {
        const Scene scene = room(albedo);
        test::Stage stage(scene, 2);
        FrameSettings settings{64, 64, 30, 3};
        const test::Frames without = test::render(stage, camera, settings, 16);
        // Of other random numbers, or the paths in common would hide what differs.
        settings.seed = 4;
        settings.roulette_from = 1;
        const test::Frames with = test::render(stage, camera, settings, 16);
        test::Mean difference, mean;
        for (std::size_t i = 0; i < with.image.size(); ++i) {
            difference.add(with.image.at(i).y - without.image.at(i).y);
            mean.add(without.image.at(i).y);
        }
        EXPECT_NEAR(difference.value(), 0.0, 4.0 * difference.sigma()) << albedo;
        EXPECT_LT(difference.sigma(), 0.02 * mean.value()) << albedo;
        EXPECT_LT(shaded(with), shaded(without) * 9 / 10) << albedo;
    }
}

// Every path of a convex body under even light brings the albedo, or with roulette 1 with that probability.
TEST(Roulette, WeighsSurvivorsByTheirProbability) {
    for (const float albedo : {0.25f, 1.0f}) {
        Scene scene;
        test::add_material(scene, test::matte(gray(albedo)));
        scene.spheres.push_back({{0, 0, 0}, 1.0f});
        test::Stage stage(scene, 2);
        FrameSettings settings{128, 128, 2, 3};
        settings.roulette_from = 0;
        std::vector<bool> hit(128 * 128);
        const test::Frames frames = test::render(stage, test::looking_from({0, 0, 2.5f}, {0, 0, 0}), settings,
                                                 1, "ctp", [&](const BounceView& view) {
                                                     for (const std::uint32_t slot : view.slots)
                                                         if (view.bounce == 0)
                                                             hit[slot] =
                                                                 view.hits.primitive[slot] != kNoPrimitive;
                                                 });
        const float probability = std::min(albedo, 0.95f);
        test::Mean survivors;
        for (std::size_t i = 0; i < hit.size(); ++i) {
            if (!hit[i]) continue;
            const float light = frames.image.at(i).x;
            if (light != 0.0f) {
                ASSERT_FLOAT_EQ(light, albedo / probability);
            }
            survivors.add(light != 0.0f ? 1.0 : 0.0);
        }
        EXPECT_GT(survivors.count(), 3000.0);
        EXPECT_NEAR(survivors.value(), probability,
                    4.0 * std::sqrt(probability * (1 - probability) / survivors.count()));
    }
}

TEST(Roulette, IsTheSameForEveryStrategyAndOffIsAsIfItWereNotThere) {
    const Scene scene = test::motley();
    test::Stage stage(scene, 2);
    FrameSettings settings{61, 43, 6, 9};
    const std::uint64_t off = test::render(stage, test::kMotleyCamera, settings, 2).image.hash();
    settings.roulette_from = settings.bounces + 1;  // later than any path gets
    EXPECT_EQ(test::render(stage, test::kMotleyCamera, settings, 2).image.hash(), off);
    settings.roulette_from = 2;
    const std::uint64_t on = test::render(stage, test::kMotleyCamera, settings, 2).image.hash();
    EXPECT_NE(on, off);
    for (const std::string& shade : shade_strategies())
        EXPECT_EQ(test::render(stage, test::kMotleyCamera, settings, 2, shade).image.hash(), on) << shade;
}

}  // namespace
}  // namespace ctpbench
