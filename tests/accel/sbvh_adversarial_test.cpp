// Inputs that have broken tree builders: see the notes on each.
#include <gtest/gtest.h>

#include <limits>

#include "tests/accel/check_tree.h"
#include "tests/accel/soups.h"

namespace ctpbench::test {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

std::vector<SbvhSettings> all_settings() {
    std::vector<SbvhSettings> all{SbvhSettings::quality(), SbvhSettings::paper(), SbvhSettings::quality()};
    all.back().single_type_leaves = true;
    return all;
}

void build_with_all_settings(const Scene& scene, int steps = 6) {
    for (const SbvhSettings& s : all_settings()) build_and_check(scene, s, steps);
}

// Each triangle half as far from the origin and half as large as the one before: splits peel them off one
// by one, so only the depth limit keeps the tree shallow.
TEST(SbvhAdversarial, HalvingTriangles) {
    for (const int copies : {1, 7}) {
        Scene scene;
        for (int i = 0; i < 126; ++i) {
            const float s = std::ldexp(1.0f, -i);
            for (int c = 0; c < copies; ++c)
                add_triangle(scene, {s, 0, 0}, {s, s * 0.5f, 0}, {s, 0, s * 0.5f});
            if (copies > 1) scene.spheres.push_back({{s, 0, 0}, s * 0.1f});
        }
        build_with_all_settings(scene);
        SbvhSettings bins = SbvhSettings::paper();
        bins.fill_leaves = false;
        bins.max_leaf = 1;
        build_and_check(scene, bins);
    }
}

// The same at three scales at once, so that the deep part starts deep.
TEST(SbvhAdversarial, HalvingTrianglesInEveryDirection) {
    Scene scene;
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i < 120; ++i) {
            Vec3 p{0, 0, 0}, q{0, 0, 0}, r{0, 0, 0};
            const float s = std::ldexp(1.0f, 40 - i);
            p[axis] = s;
            q[axis] = s * 1.2f;
            r[(axis + 1) % 3] = s * 0.1f;
            add_triangle(scene, p, q, p + r);
            scene.spheres.push_back({q, s * 0.01f});
        }
    }
    build_with_all_settings(scene);
}

TEST(SbvhAdversarial, CoincidentTriangles) {
    Scene scene;
    for (int i = 0; i < 5000; ++i) add_triangle(scene, {0, 0, 0}, {1, 0, 0.5f}, {0, 1, 0.25f});
    for (const SbvhSettings& s : all_settings()) {
        const Tree tree = build_and_check(scene, s, 4);
        EXPECT_LE(tree.depth, 14u) << "halving 5000 references needs no more";
    }
}

TEST(SbvhAdversarial, CoincidentMixedTypes) {
    Scene scene;
    for (int i = 0; i < 500; ++i) {
        add_triangle(scene, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
        scene.spheres.push_back({{0, 0, 0}, 1});
    }
    build_with_all_settings(scene);
}

// Different sizes around one center: no object split exists, spatial splits do.
TEST(SbvhAdversarial, ConcentricSpheres) {
    Scene scene;
    for (int i = 1; i <= 300; ++i) scene.spheres.push_back({{1, 2, 3}, 0.01f * static_cast<float>(i)});
    build_with_all_settings(scene, 16);
}

TEST(SbvhAdversarial, AllZeroArea) {
    Scene points, line;
    Random random(1);
    for (int i = 0; i < 500; ++i) {
        const Vec3 p = random.point(-1, 1);
        add_triangle(points, p, p, p);
        const float x = random.uniform(-1, 1), y = random.uniform(-1, 1);
        add_triangle(line, {x, 0, 0}, {y, 0, 0}, {0.5f * (x + y), 0, 0});
    }
    build_with_all_settings(points);
    build_with_all_settings(line);
    for (const SbvhSettings& s : all_settings()) {
        EXPECT_LE(build_sbvh(ScenePrimitives(line), s).depth, 20u) << "without areas, splits should be even";
    }
}

TEST(SbvhAdversarial, FlatGrid) {
    Scene scene;
    for (int i = 0; i < 24; ++i) {
        for (int j = 0; j < 24; ++j) {
            const float x = static_cast<float>(i), y = static_cast<float>(j);
            add_triangle(scene, {x, y, 0.1f}, {x + 1, y, 0.1f}, {x + 1, y + 1, 0.1f});
            add_triangle(scene, {x, y, 0.1f}, {x + 1, y + 1, 0.1f}, {x, y + 1, 0.1f});
        }
    }
    build_with_all_settings(scene);
}

TEST(SbvhAdversarial, HugeAndTiny) {
    Scene scene = needles(100, {0, 0, 0}, 1e-20f, 1);
    for (const float scale : {1e-40f, 1e-30f, 1e-6f, 1.0f, 1e6f, 1e12f, 1e18f}) {
        const Scene more = needles(40, {0, 0, 0}, scale, 2);
        for (std::uint32_t i = 0; i < 40; ++i) {
            const TriangleShape t = more.mesh.triangle(i);
            add_triangle(scene, t.a, t.b, t.c);
        }
    }
    scene.spheres.push_back({{0, 0, 0}, 1e17f});
    scene.spheres.push_back({{0, 0, 0}, 1e-38f});
    build_with_all_settings(scene);
}

TEST(SbvhAdversarial, UnusablePrimitivesAreLeftOutAndCounted) {
    Scene scene = needles(50, {0, 0, 0}, 1, 3);
    const Vec3 a{0, 0, 0}, b{1, 0, 0};
    for (const float bad : {kNan, kInf, -kInf, 1e19f, -3e38f}) {
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 v{0, 1, 0};
            v[axis] = bad;
            add_triangle(scene, a, b, v);
            add_triangle(scene, a, v, b);
            add_triangle(scene, v, a, b);
            scene.spheres.push_back({v, 1});
        }
    }
    for (const float radius : {kNan, kInf, -1.0f, 1e30f}) scene.spheres.push_back({a, radius});
    for (const SbvhSettings& s : all_settings()) {
        const Tree tree = build_and_check(scene, s);
        EXPECT_EQ(tree.skipped, 5u * 3 * 4 + 4);
    }
    Scene nothing;
    add_triangle(nothing, {kNan, 0, 0}, a, b);
    const Tree tree = build_sbvh(ScenePrimitives(nothing), SbvhSettings::quality());
    EXPECT_TRUE(tree.nodes.empty());
    EXPECT_EQ(tree.skipped, 1u);
}

}  // namespace
}  // namespace ctpbench::test
