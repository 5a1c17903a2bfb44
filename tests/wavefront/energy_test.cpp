// Where no light is brighter than 1 nothing is: in heaps of triangles and spheres with materials at random.
// And no sample is negative or no number, whatever the scale.
#include <gtest/gtest.h>

#include <vector>

#include "wavefront/physics.h"

namespace ctpbench {
namespace {

using test::gray;

enum class Walls { none, all_around };
enum class Glossy { no, yes };

// A heap within the radius 2; `brightness` is of the lights and of what is outside.
Scene heap(std::uint64_t seed, Walls walls, Glossy glossy, Vec3 brightness, float scale = 1.0f,
           float offset = 0.0f) {
    Scene scene = test::soup(1500, 40, seed, scale, gray(offset));
    test::Random random(seed + 1000);
    scene.materials.clear();
    for (int i = 0; i < 12; ++i) {
        const Vec3 a = random.point(0.5f, 1.0f), b = random.point(0.5f, 1.0f);
        const float exponent = std::pow(10.0f, random.uniform(-1.0f, 3.0f));
        switch (i % 4) {
            case 0:
                test::add_material(scene, test::matte(a));
                break;
            case 1:
                test::add_material(scene, test::mirror(a));
                break;
            case 2:
                test::add_material(scene, test::emissive(brightness * a));
                break;
            case 3:
                test::add_material(scene,
                                   glossy == Glossy::yes ? test::plastic(a, b, exponent) : test::matte(b));
        }
    }
    for (std::uint32_t& m : scene.mesh.material) m = static_cast<std::uint32_t>(random.uniform(0.0f, 11.99f));
    scene.sphere_material = glossy == Glossy::yes ? 3 : 1;
    if (walls == Walls::all_around)
        test::add_mesh(scene, test::star(2, 4.0f * scale, gray(offset), 5, 0.0f), 0);
    scene.ambient = brightness;
    return scene;
}
Camera amid(float scale = 1.0f, float offset = 0.0f) {
    return test::looking_from(gray(offset) + scale * Vec3{0.2f, 0.1f, 2.4f}, gray(offset));
}

TEST(Energy, NoPathIsBrighterThanTheLights) {
    for (const Walls walls : {Walls::none, Walls::all_around})
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            const Scene scene = heap(seed, walls, Glossy::no, gray(1.0f));
            test::Stage stage(scene, 2);
            const test::Frames frames = test::render(stage, amid(), {64, 64, 10, seed});
            float most = 0.0f;
            for (std::size_t i = 0; i < frames.image.size(); ++i)
                for (int c = 0; c < 3; ++c) {
                    ASSERT_LE(frames.image.at(i)[c], 1.0f);
                    most = std::max(most, frames.image.at(i)[c]);
                }
            EXPECT_GT(most, 0.9f) << "it is not dark, either";
        }
}

// A sample of plastic may weigh more than 1, but not on average.
TEST(Energy, NoPictureIsBrighterThanTheLights) {
    for (const Walls walls : {Walls::none, Walls::all_around})
        for (std::uint64_t seed = 1; seed <= 2; ++seed) {
            const Scene scene = heap(seed, walls, Glossy::yes, gray(1.0f));
            test::Stage stage(scene, 2);
            const test::Frames frames = test::render(stage, amid(), {48, 48, 10, seed}, 16);
            EXPECT_EQ(test::clamped(frames), 0u);
            for (int c = 0; c < 3; ++c) {
                test::Mean mean;
                for (std::size_t i = 0; i < frames.image.size(); ++i) mean.add(frames.image.at(i)[c]);
                EXPECT_LE(mean.value(), 1.0 + 4.0 * mean.sigma());
                EXPECT_GT(mean.value(), 0.05);
            }
        }
}

// White plastic that returns all it can, in a heap where a path meets much of it: what is gained at each
// bounce, were it a percent, would grow to show.
TEST(Energy, AHeapOfWhitePlasticIsNotBrighterThanTheSky) {
    for (const float exponent : {0.0f, 20.0f, 500.0f}) {
        Scene scene = test::soup(1500, 40, 3);
        scene.materials = {{"", test::plastic(gray(0.5f), gray(0.5f), exponent)}};
        test::Stage stage(scene, 2);
        const test::Frames frames = test::render(stage, amid(), {48, 48, 30, 1}, 16);
        test::Mean mean;
        for (std::size_t i = 0; i < frames.image.size(); ++i) mean.add(frames.image.at(i).x);
        EXPECT_LE(mean.value(), 1.0 + 4.0 * mean.sigma()) << "exponent " << exponent;
        EXPECT_GT(mean.value(), 0.4) << "exponent " << exponent;
        RecordProperty("exponent_" + std::to_string(static_cast<int>(exponent)),
                       std::to_string(mean.value()));
    }
}

TEST(Energy, EverySampleIsANumber) {
    struct Place {
        float scale, offset;
    };
    for (const Place at : {Place{1.0f, 0.0f}, {1.0f, 1e4f}, {1e-3f, 0.0f}, {1e3f, 0.0f}})
        for (const Walls walls : {Walls::none, Walls::all_around}) {
            const Scene scene = heap(5, walls, Glossy::yes, {1.0f, 0.5f, 0.0f}, at.scale, at.offset);
            test::Stage stage(scene, 2);
            std::uint32_t unsound = 0;
            const test::Frames frames = test::render(
                stage, amid(at.scale, at.offset), {64, 64, 10, 8}, 4, "ctp", [&](const BounceView& view) {
                    for (const std::uint32_t slot : view.slots) {
                        const Ray ray = view.rays.load(slot);
                        unsound += !(std::fabs(length(ray.direction) - 1.0f) <= 1e-4f) ||
                                   !std::isfinite(dot(ray.origin, ray.origin));
                    }
                });
            EXPECT_EQ(test::clamped(frames), 0u) << "scale " << at.scale << ", offset " << at.offset;
            EXPECT_EQ(unsound, 0u) << "scale " << at.scale << ", offset " << at.offset;
            double light = 0.0;
            for (std::size_t i = 0; i < frames.image.size(); ++i) {
                for (int c = 0; c < 3; ++c) ASSERT_GE(frames.image.at(i)[c], 0.0f);
                ASSERT_EQ(frames.image.at(i).z, 0.0f) << "no light is blue";
                light += frames.image.at(i).x;
            }
            EXPECT_GT(light, 0.02 * 64 * 64);
        }
}

}  // namespace
}  // namespace ctpbench
