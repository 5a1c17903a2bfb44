// The recipes' tools: closed shapes are closed and face outward, counts are exact, numbers are portable.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "scene/recipes/cloth.h"
#include "scene/recipes/foliage.h"
#include "scene/recipes/shapes.h"
#include "scene/recipes/surface.h"
#include "scene/recipes/walls.h"

namespace ctpbench::recipe {
namespace {

using Point = std::tuple<float, float, float>;
Point key(Vec3 p) { return {p.x, p.y, p.z}; }

// Every edge is walked once in either direction; vertices are matched by position, so seams count.
bool closed(const Mesh& mesh) {
    std::map<std::pair<Point, Point>, int> edges;
    for (const auto& t : mesh.triangles) {
        for (int k = 0; k < 3; ++k) {
            const Point a = key(mesh.positions[t[k]]), b = key(mesh.positions[t[(k + 1) % 3]]);
            a < b ? ++edges[{a, b}] : --edges[{b, a}];
        }
    }
    return std::all_of(edges.begin(), edges.end(), [](const auto& e) { return e.second == 0; });
}

double volume(const Mesh& mesh) {
    double six = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const TriangleShape t = mesh.triangle(i);
        six += dot(t.a, cross(t.b, t.c));
    }
    return six / 6;
}

double area(const Mesh& mesh) {
    double twice = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const TriangleShape t = mesh.triangle(i);
        twice += length(cross(t.b - t.a, t.c - t.a));
    }
    return twice / 2;
}

constexpr double pi = 3.14159265358979;

TEST(Circle, AgreesWithTheLibrary) {
    for (int i = -2000; i <= 2000; ++i) {
        const double turns = i / 777.0;
        EXPECT_NEAR(circle(turns).cos, std::cos(2 * pi * turns), 1e-7);
        EXPECT_NEAR(circle(turns).sin, std::sin(2 * pi * turns), 1e-7);
    }
    EXPECT_EQ(circle(0.25).cos, 0.0f);
    EXPECT_EQ(circle(1).cos, 1.0f);
}

TEST(RandomNumbers, AreUniformAndSeparateByStream) {
    Random a(1, 0), b(1, 1), again(1, 0);
    double sum = 0, squares = 0;
    int equal = 0;
    constexpr int n = 100000;
    for (int i = 0; i < n; ++i) {
        const float x = a.unit();
        ASSERT_GE(x, 0.0f);
        ASSERT_LT(x, 1.0f);
        ASSERT_EQ(x, again.unit());
        equal += x == b.unit();
        sum += x;
        squares += static_cast<double>(x) * x;
    }
    EXPECT_NEAR(sum / n, 0.5, 5 * std::sqrt(1.0 / 12 / n));
    EXPECT_NEAR(squares / n, 1.0 / 3, 5 * std::sqrt(4.0 / 45 / n));
    EXPECT_LT(equal, 5);
}

TEST(Shapes, BoxIsClosedWithItsVolume) {
    Mesh mesh;
    box(mesh, at({1, 2, 3}, 0.1f), {-1, -1, -1}, {1, 2, 3}, 0);
    EXPECT_EQ(mesh.triangles.size(), 12u);
    EXPECT_TRUE(closed(mesh));
    EXPECT_NEAR(volume(mesh), 24, 1e-4);
}

TEST(Shapes, CushionIsClosedWithinItsBox) {
    Mesh mesh;
    cushion(mesh, {}, {1, 1, 1}, 8, 0);
    EXPECT_TRUE(closed(mesh));
    EXPECT_LT(volume(mesh), 8);
    EXPECT_GT(volume(mesh), 4 * pi / 3);
}

TEST(Shapes, LatheOfACylinderHasItsVolume) {
    Mesh mesh;
    constexpr ProfilePoint profile[] = {{0, 0}, {1, 0}, {1, 2}, {0, 2}};
    lathe(mesh, standing({1, 1, 1}, normalize(Vec3{1, 2, 3})), profile, 256, 0);
    EXPECT_TRUE(closed(mesh));
    EXPECT_NEAR(volume(mesh), 2 * pi, 0.01);
}

TEST(Shapes, TubeIsClosedWithItsVolume) {
    Mesh mesh;
    constexpr Vec3 path[] = {{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {0, 3, 0}};
    tube(mesh, path, 0.5f, 0.5f, 128, 0);
    EXPECT_TRUE(closed(mesh));
    EXPECT_NEAR(volume(mesh), 3 * pi / 4, 0.005);
}

TEST(Shapes, TorusIsClosedWithItsVolume) {
    Mesh mesh;
    torus(mesh, {}, 2, 0.5f, 128, 64, 0);
    EXPECT_TRUE(closed(mesh));
    EXPECT_NEAR(volume(mesh), 2 * pi * 2 * pi * 0.25, 0.03);
}

TEST(Shapes, PrismIsClosedWithItsVolume) {
    Mesh mesh;
    constexpr OutlinePoint outline[] = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
    prism(mesh, {}, outline, 3, 0);
    EXPECT_TRUE(closed(mesh));
    EXPECT_NEAR(volume(mesh), 6, 1e-5);
}

TEST(Surface, ExactCountsCoverTheSquare) {
    for (const float aspect : {0.2f, 1.0f, 7.0f}) {
        for (std::size_t n = 2; n < 700; ++n) {
            Mesh mesh;
            exact_surface(mesh, n, aspect, 0, [](float u, float v) { return Vec3{u, v, 0}; });
            ASSERT_EQ(mesh.triangles.size(), n);
            ASSERT_NEAR(area(mesh), 1, 1e-4) << n;
        }
    }
}

TEST(Surface, ClothHasTheCountAskedFor) {
    Random random(3, 0);
    Mesh mesh;
    hang_cloth(mesh, {}, {1, 3, 0.1f, 6, 0.4f, 0.4f}, 4321, 0, random);
    EXPECT_EQ(mesh.triangles.size(), 4321u);
    EXPECT_GT(area(mesh), 2);
}

TEST(Walls, PiercedWallLosesItsOpeningsAndGainsTheirReveals) {
    Mesh mesh;
    constexpr Opening openings[] = {{1, 2, 1, 2}, {3, 5, 0.5f, 2}};
    pierced_wall(mesh, {}, 6, 3, openings, 0.5f, 0);
    EXPECT_NEAR(area(mesh), 18 - 1 - 3 + 0.5 * (4 + 7), 1e-4);
}

TEST(Walls, ArchBayHasTheAreaOfItsParts) {
    Mesh mesh;
    arch_bay(mesh, {}, {4, 1, 2, 4, 0.5f, 256}, 0);
    EXPECT_NEAR(area(mesh), 2 * (8 - pi / 2) + 0.5 * (pi + 2), 0.01);
}

TEST(Foliage, LeavesAreCountedExactlyAndStayAboveGround) {
    const Twig twigs[] = {{{0, 0, 0}, {0, 1, 0}}};
    const MaterialId materials[] = {5, 7};
    for (std::size_t n = 0; n < 20; ++n) {
        Random random(n, 0);
        Mesh mesh;
        scatter_leaves(mesh, twigs, n, {0.1f, 0.05f, 0.5f, {0, 0, 0}, materials}, random);
        EXPECT_EQ(mesh.triangles.size(), n);
        for (const Vec3& p : mesh.positions) EXPECT_GE(p.y, 0.0f);
    }
}

TEST(Foliage, LeavesOnAWallStayInFrontOfIt) {
    const Twig twigs[] = {{{0, 2, 0.05f}, {0, 3, 0.05f}}};
    const MaterialId materials[] = {0};
    Random random(1, 0);
    Mesh mesh;
    scatter_leaves(mesh, twigs, 400, {0.01f, 0.01f, 0.4f, {0, 0, 1}, materials}, random);
    for (const Vec3& p : mesh.positions) EXPECT_GT(p.z, 0.05f);
}

TEST(Share, AddsUp) {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < 7; ++i) sum += share(1000, i, 7);
    EXPECT_EQ(sum, 1000u);
}

}  // namespace
}  // namespace ctpbench::recipe
