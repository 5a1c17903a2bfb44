// Textures in whole frames: a surface where alpha is 0 is as if it were not there, for camera rays and for
// scattered ones; where it is 1 it is opaque; and colours are where texture coordinates put them.
#include <gtest/gtest.h>

#include <vector>

#include "wavefront/physics.h"

namespace ctpbench {
namespace {

using test::gray;

constexpr std::uint32_t kSize = 96;
constexpr std::uint16_t kOne = 65535;

test::Frames from_above(const Scene& scene, std::uint32_t bounces, const BounceObserver& observe = {}) {
    test::Stage stage(scene, 2);
    return test::render(stage, test::looking_from({0.2f, -0.3f, 3.0f}, {0, 0, 0}), {kSize, kSize, bounces, 6},
                        1, "ctp", observe);
}

// A convex gray ball under ambient light, and around it a creased shell and above it a square.
enum class Wrapping { none, textured, plain };
Scene ball_in(Wrapping wrapping, std::uint16_t alpha = kOne) {
    Scene scene;
    const std::uint32_t ball = test::add_material(scene, test::matte(gray(0.5f)));
    const std::uint32_t paper = test::add_material(scene, test::matte(gray(0.25f)));
    test::add_mesh(scene, test::star(3, 0.5f, {0, 0, 0}, 1, 0.0f), ball);
    if (wrapping == Wrapping::none) return scene;
    test::add_mesh(scene, test::star(2, 0.9f, {0, 0, 0}, 1, 0.2f), paper);
    test::add_square(scene, 0.8f, 1.2f, paper);
    if (wrapping == Wrapping::textured) {
        scene.texels = {{kOne, kOne, kOne, alpha}};
        scene.materials[paper].look.texture = {0, 1, 1};
    }
    return scene;
}

TEST(Cutouts, AreAsIfNotThere) {
    std::size_t with = 0, without = 0;  // intersections
    const test::Frames cut = from_above(ball_in(Wrapping::textured, 0), 20,
                                        [&](const BounceView& view) { with += view.slots.size(); });
    const test::Frames bare = from_above(ball_in(Wrapping::none), 20,
                                         [&](const BounceView& view) { without += view.slots.size(); });
    std::size_t ball = 0;
    for (std::size_t i = 0; i < bare.image.size(); ++i) {
        ASSERT_EQ(cut.image.at(i), bare.image.at(i)) << "pixel " << i;
        ball += bare.image.at(i) == gray(0.5f);
    }
    EXPECT_GT(ball, 500u);
    EXPECT_GT(with, without + 5000);
}

TEST(Cutouts, AreOpaqueWithoutHoles) {
    const test::Frames textured = from_above(ball_in(Wrapping::textured), 5);
    const test::Frames plain = from_above(ball_in(Wrapping::plain), 5);
    std::size_t wrapped = 0;
    for (std::size_t i = 0; i < plain.image.size(); ++i) {
        ASSERT_NEAR(textured.image.at(i).x, plain.image.at(i).x, 1e-6) << "pixel " << i;
        ASSERT_NE(plain.image.at(i), gray(0.5f)) << "the ball is hidden";
        wrapped += plain.image.at(i).x <= 0.25f;
    }
    EXPECT_GT(wrapped, 1000u);
}

// A path that passes has met something: it is one of the intersections that a path may have.
TEST(Cutouts, TakeABounceToPass) {
    Scene scene;
    test::add_material(scene, test::matte(gray(0.5f)));
    scene.materials[0].look.texture = {0, 1, 1};
    scene.texels = {{kOne, kOne, kOne, 0}};
    test::add_square(scene, 9.0f, 0.0f, 0);
    for (const std::uint32_t bounces : {0u, 1u}) {
        const test::Frames frames = from_above(scene, bounces);
        for (std::size_t i = 0; i < frames.image.size(); ++i)
            ASSERT_EQ(frames.image.at(i), gray(static_cast<float>(bounces)));
    }
}

// A square with a texture of two by two texels, one of which is a hole; each pixel against the bilinear
// interpolation where its ray meets the square's plane.
TEST(Cutouts, LieWhereTextureCoordinatesSay) {
    Scene scene;
    test::add_material(scene, test::matte({1.0f, 0.8f, 0.5f}));
    scene.materials[0].look.texture = {0, 2, 2};
    scene.texels = {
        {kOne, 10000, 0, kOne}, {20000, kOne, 5000, kOne}, {0, 30000, kOne, 0}, {40000, 0, 50000, kOne}};
    test::add_square(scene, 1.0f, 0.0f, 0);
    std::vector<Ray> rays(kSize * kSize);
    const test::Frames frames = from_above(scene, 2, [&](const BounceView& view) {
        for (const std::uint32_t slot : view.slots)
            if (view.bounce == 0) rays[slot] = view.rays.load(slot);
    });
    int colored = 0, holes = 0, beside = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Ray& ray = rays[i];
        const double t = -double{ray.origin.z} / ray.direction.z;
        const double u = 0.5 + 0.5 * (ray.origin.x + t * ray.direction.x);
        const double v = 0.5 + 0.5 * (ray.origin.y + t * ray.direction.y);
        const Vec3 seen = frames.image.at(i);
        if (u < -1e-5 || u > 1.0 + 1e-5 || v < -1e-5 || v > 1.0 + 1e-5) {
            ASSERT_EQ(seen, gray(1.0f));
            ++beside;
            continue;
        }
        // The share of the first of two texels, which are centred at 1/4 and 3/4 and repeat.
        const auto share = [](double x) { return std::fabs(1.0 - 2.0 * std::fabs(x - 0.25)); };
        const double weights[4] = {share(u) * share(v), (1 - share(u)) * share(v), share(u) * (1 - share(v)),
                                   (1 - share(u)) * (1 - share(v))};
        double r = 0.0, g = 0.0, b = 0.0, a = 0.0;
        for (int k = 0; k < 4; ++k) {
            const Texel& texel = scene.texels[k];
            r += weights[k] * texel.r / kOne, g += weights[k] * texel.g / kOne;
            b += weights[k] * texel.b / kOne, a += weights[k] * texel.a / kOne;
        }
        if (std::fabs(a - 0.5) < 1e-4) continue;  // rounding decides
        if (a < 0.5) {
            ASSERT_EQ(seen, gray(1.0f)) << u << ", " << v;
            ++holes;
        } else {
            ASSERT_NEAR(seen.x, r, 1e-5) << u << ", " << v;
            ASSERT_NEAR(seen.y, g * 0.8, 1e-5) << u << ", " << v;
            ASSERT_NEAR(seen.z, b * 0.5, 1e-5) << u << ", " << v;
            ++colored;
        }
    }
    EXPECT_GT(colored, 1000);
    EXPECT_GT(holes, 200);
    EXPECT_GT(beside, 500);
}

}  // namespace
}  // namespace ctpbench
