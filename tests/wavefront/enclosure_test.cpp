// A hollow sphere of which a share p shines with radiance E and the rest is matte with albedo r. From any
// point inside a sphere, directions with density cos / pi reach all of its area alike; so of a path that
// starts at the matte part each bounce finds light with probability p, and with B bounces
//
//     L = E p r (1 + q + ... + q^(B-1)),   q = r (1 - p).
//
// The series without end is E p r / (1 - q). What B bounces leave out of it is the share q^B.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "wavefront/physics.h"

namespace ctpbench {
namespace {

using test::gray;

constexpr std::uint32_t kSize = 128, kSeeds = 12;

struct Enclosure {
    Scene scene;
    double share;  // of the area, that shines
};

// `shines(i, center)` picks the triangles that do.
template <class F>
Enclosure enclosure(float albedo, float radiance, F&& shines) {
    Enclosure e;
    test::add_material(e.scene, test::matte(gray(albedo)));
    test::add_material(e.scene, test::emissive(gray(radiance)));
    test::add_mesh(e.scene, test::star(5, 1.0f, {0, 0, 0}, 1, 0.0f), 0);
    double area = 0.0, shining = 0.0;
    for (std::uint32_t i = 0; i < e.scene.mesh.triangles.size(); ++i) {
        const TriangleShape t = e.scene.mesh.triangle(i);
        const double a = 0.5 * length(cross(t.b - t.a, t.c - t.a));
        area += a;
        if (!shines(i, (t.a + t.b + t.c) * (1.0f / 3.0f))) continue;
        e.scene.mesh.material[i] = 1, shining += a;
    }
    e.share = shining / area;
    e.scene.ambient = gray(1e6f);  // a leak would show
    return e;
}

// Of the samples whose first hit is matte.
test::Mean traced(const Enclosure& e, std::uint32_t bounces) {
    test::Stage stage(e.scene, 2);
    const Camera camera = test::looking_from({0.1f, -0.2f, 0.3f}, {0.3f, 0.1f, -1.0f});
    test::Mean mean;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        std::vector<bool> matte(kSize * kSize);
        const test::Frames frames =
            test::render(stage, camera, {kSize, kSize, bounces, seed}, 1, "ctp", [&](const BounceView& view) {
                if (view.bounce != 0) return;
                for (const std::uint32_t slot : view.slots) {
                    const std::uint32_t primitive = view.hits.primitive[slot];
                    matte[slot] = primitive != kNoPrimitive && e.scene.mesh.material[primitive] == 0;
                }
            });
        for (std::uint32_t i = 0; i < kSize * kSize; ++i)
            if (matte[i]) mean.add(frames.image.at(i).x);
    }
    return mean;
}

double predicted(double radiance, double p, double albedo, std::uint32_t bounces) {
    const double q = albedo * (1.0 - p);
    return radiance * p * albedo * (1.0 - std::pow(q, bounces)) / (1.0 - q);
}

// Flat triangles do not see themselves and chords are not arcs: with 8192 triangles that is worth some 1e-4
// of the light, which the tolerance allows for.
constexpr double kTessellation = 5e-4;

void expect_series(const Enclosure& e, float albedo, float radiance) {
    double values[2];
    int i = 0;
    for (const std::uint32_t bounces : {10u, 2u}) {
        const double expected = predicted(radiance, e.share, albedo, bounces);
        const test::Mean mean = traced(e, bounces);
        EXPECT_NEAR(mean.value(), expected, 4.0 * mean.sigma() + kTessellation * expected)
            << bounces << " bounces";
        EXPECT_LT(mean.sigma(), 0.01 * expected);
        EXPECT_GT(mean.count(), 0.5 * kSize * kSize * kSeeds);
        values[i++] = mean.value();
        const std::string name = "bounces_" + std::to_string(bounces);
        testing::Test::RecordProperty(name, std::to_string(mean.value()) + " +- " +
                                                std::to_string(mean.sigma()) + ", predicted " +
                                                std::to_string(expected));
    }
    const double q = albedo * (1.0 - e.share);
    const double ratio = (1.0 - q * q) / (1.0 - std::pow(q, 10.0));
    EXPECT_NEAR(values[1] / values[0], ratio, 0.01) << "what two bounces see of what ten do";
    testing::Test::RecordProperty(
        "ratio", std::to_string(values[1] / values[0]) + ", predicted " + std::to_string(ratio));
}

TEST(Enclosure, LitByACapFollowsTheSeries) {
    const Enclosure e = enclosure(0.9f, 2.0f, [](std::uint32_t, Vec3 at) { return at.z > 0.4f; });
    EXPECT_NEAR(e.share, 0.3, 0.01) << "a cap's share is that of its height";
    expect_series(e, 0.9f, 2.0f);
}

TEST(Enclosure, LitByScatteredTrianglesFollowsTheSeries) {
    test::Random random(6);
    const Enclosure e =
        enclosure(0.7f, 1.0f, [&](std::uint32_t, Vec3) { return random.uniform(0.0f, 1.0f) < 0.1f; });
    expect_series(e, 0.7f, 1.0f);
}

// A furnace at one temperature: the walls are white, a fifth of them shines with radiance 1, and so would
// everything if paths went on for ever. Each bounce finds no light with probability 0.8. Ten bounces from a
// wall lack 0.8^10 of the light; along a line of sight, which finds a light itself a fifth of the time, they
// lack 0.8^11 = 8.6 %.
TEST(Enclosure, AFurnaceLacksWhatItsBouncesLeaveOut) {
    test::Random random(7);
    const Enclosure e =
        enclosure(1.0f, 1.0f, [&](std::uint32_t, Vec3) { return random.uniform(0.0f, 1.0f) < 0.2f; });
    ASSERT_NEAR(e.share, 0.2, 0.02);
    const test::Mean wall = traced(e, 10);
    const double p = e.share, seen = p + (1.0 - p) * wall.value();
    const double lacking = std::pow(1.0 - p, 11);
    EXPECT_NEAR(lacking, 0.086, 0.025);
    EXPECT_NEAR(1.0 - seen, lacking, (1.0 - p) * 4.0 * wall.sigma() + kTessellation);
    RecordProperty("lacking", std::to_string(1.0 - seen) + " +- " + std::to_string((1.0 - p) * wall.sigma()) +
                                  ", predicted " + std::to_string(lacking));
}

}  // namespace
}  // namespace ctpbench
