// The white furnace: under the same light from everywhere, what absorbs nothing is invisible, and a convex
// body shows its albedo, exactly. A path that met its own body again would show: its pixel would be darker.
#include <gtest/gtest.h>

#include <vector>

#include "kernels/materials/hemisphere.h"
#include "wavefront/physics.h"

namespace ctpbench {
namespace {

using test::gray;

// A body of radius `scale` about (offset, offset, offset), seen from `distance` radii away.
struct Place {
    float scale, offset, distance = 2.5f;
};

enum class Body { mesh, sphere };

Scene furnace(Body body, const MaterialDescription& look, Place at) {
    Scene scene;
    test::add_material(scene, look);
    const Vec3 center = gray(at.offset);
    if (body == Body::mesh) {
        test::add_mesh(scene, test::star(4, at.scale, center, 1, 0.0f), 0);
    } else {
        scene.spheres.push_back({center, at.scale});
    }
    return scene;  // ambient is 1
}
Camera before(Place at) {
    const Vec3 center = gray(at.offset);
    const Vec3 eye = center + at.scale * at.distance * normalize({0.15f, 0.1f, 1.0f});
    Camera camera = test::looking_from(eye, center);
    camera.fov_degrees = 360.0f / 3.14159265f * std::atan(1.5f / at.distance);
    return camera;
}

// Each pixel has one sample: it is the albedo's where it hit, and the ambient light's where it did not.
void expect_albedo(Body body, const MaterialDescription& look, float albedo, Place at) {
    SCOPED_TRACE(testing::Message() << (body == Body::mesh ? "mesh" : "sphere") << ", type " << look.type
                                    << ", albedo " << albedo << ", scale " << at.scale << ", offset "
                                    << at.offset << ", distance " << at.distance);
    const Scene scene = furnace(body, look, at);
    test::Stage stage(scene, 2);
    std::vector<bool> hit(96 * 96);
    std::uint32_t hits = 0, hit_again = 0;
    const test::Frames frames =
        test::render(stage, before(at), {96, 96, 10, 3}, 1, "ctp", [&](const BounceView& view) {
            for (const std::uint32_t slot : view.slots) {
                if (view.hits.primitive[slot] == kNoPrimitive) continue;
                if (view.bounce == 0) hit[slot] = true;
                ++(view.bounce == 0 ? hits : hit_again);
            }
        });
    for (std::size_t i = 0; i < hit.size(); ++i)
        ASSERT_EQ(frames.image.at(i), gray(hit[i] ? albedo : 1.0f)) << "pixel " << i;
    EXPECT_EQ(hit_again, 0u) << "paths that leave a convex body";
    EXPECT_GT(hits, 1500u);
    EXPECT_LT(hits, 96u * 96u - 1500u);
}

TEST(Furnace, AConvexBodyShowsItsAlbedoWhereverItIs) {
    for (const Place at : {Place{1e-3f, 0.0f}, {1.0f, 0.0f}, {1e3f, 0.0f}, {1.0f, 1e4f}, {1.0f, 0.0f, 3e3f}})
        for (const Body body : {Body::mesh, Body::sphere})
            for (const float albedo : {1.0f, 0.5f}) {
                expect_albedo(body, test::matte(gray(albedo)), albedo, at);
                expect_albedo(body, test::mirror(gray(albedo)), albedo, at);
            }
}

// Plastic's samples differ, but on average it shows what the integral of its reflectance says for the angle
// that it is seen at.
void expect_plastic(Body body, const MaterialDescription& look) {
    const Plastic material = Plastic::make(look);
    constexpr int kSteps = 48;
    std::vector<double> reflected;  // at equal steps of the square root of the cosine
    for (int i = 0; i <= kSteps; ++i) {
        const double root = std::fmax(0.02, static_cast<double>(i) / kSteps);
        const test::Hemisphere h({0, 0, 1}, {1, 0, 0}, root * root);
        const auto f = [&](Vec3 wi) { return material.shade(h.point(), wi).x * h.cosine_of(wi); };
        reflected.push_back(test::Integral(h, f).over_all(15, 30, 1e-4));
    }
    const Scene scene = furnace(body, look, {1.0f, 0.0f});
    test::Stage stage(scene, 2);
    constexpr std::uint32_t kSamples = 8;
    std::vector<double> expected(96 * 96, 0.0);
    const test::Frames frames = test::render(
        stage, before({1.0f, 0.0f}), {96, 96, 4, 3}, kSamples, "ctp", [&](const BounceView& view) {
            if (view.bounce != 0) return;
            for (const std::uint32_t slot : view.slots) {
                const Hit hit = view.hits.load(slot);
                const Ray ray = view.rays.load(slot);
                if (hit.primitive == kNoPrimitive) {
                    expected[slot] += 1.0 / kSamples;
                    continue;
                }
                const Surface s = surface_at(stage.view.geometry(), ray, hit);
                const double at = std::sqrt(std::fmax(0.0f, -dot(s.normal, ray.direction))) * kSteps;
                const int below = std::min(kSteps - 1, static_cast<int>(at));
                expected[slot] +=
                    (reflected[below] + (at - below) * (reflected[below + 1] - reflected[below])) / kSamples;
            }
        });
    test::Mean error, image;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        image.add(frames.image.at(i).x);
        error.add(frames.image.at(i).x - expected[i]);
    }
    EXPECT_NEAR(error.value(), 0.0, 4.0 * error.sigma());
    EXPECT_LT(error.sigma(), 5e-3);
    EXPECT_LT(image.value(), 1.0);
    EXPECT_EQ(test::clamped(frames), 0u);
    testing::Test::RecordProperty("mean", std::to_string(image.value()));
    testing::Test::RecordProperty("error", std::to_string(error.value()));
    testing::Test::RecordProperty("sigma", std::to_string(error.sigma()));
}

TEST(Furnace, APlasticMeshShowsItsReflectance) {
    expect_plastic(Body::mesh, test::plastic(gray(0.3f), gray(0.7f), 40.0f));
}
TEST(Furnace, AGlossySphereShowsItsReflectance) {
    expect_plastic(Body::sphere, test::plastic(gray(0.0f), gray(1.0f), 200.0f));
}

}  // namespace
}  // namespace ctpbench
