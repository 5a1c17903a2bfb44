#include "scene/triangulate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ctpbench {
namespace {

Vec3 area_vector(const std::vector<Vec3>& points, const std::array<std::uint32_t, 3>& t) {
    return 0.5f * cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
}

std::vector<std::uint32_t> all_corners(const std::vector<Vec3>& points) {
    std::vector<std::uint32_t> corners;
    for (std::uint32_t i = 0; i < points.size(); ++i) corners.push_back(i);
    return corners;
}

// Of a flat simple polygon: every triangle turns the same way and the areas add up, so none overlap.
void expect_tiling(const std::vector<Vec3>& points, float area) {
    const auto triangles = triangulate(points, all_corners(points));
    ASSERT_EQ(triangles.size(), points.size() - 2);
    Vec3 signed_sum{};
    float sum = 0.0f;
    for (const auto& triangle : triangles) {
        const Vec3 vector = area_vector(points, triangle);
        signed_sum = signed_sum + vector;
        sum += length(vector);
    }
    EXPECT_NEAR(sum, area, 1e-5f * area);
    EXPECT_NEAR(length(signed_sum), area, 1e-5f * area);
}

TEST(Triangulate, TilesConvexPolygons) {
    std::vector<Vec3> points;
    for (int i = 0; i < 12; ++i) {
        const float angle = static_cast<float>(i) * std::numbers::pi_v<float> / 6.0f;
        points.push_back({std::cos(angle), 2.0f, std::sin(angle)});
    }
    expect_tiling(points, 3.0f);
}

TEST(Triangulate, TilesConcavePolygonsInEveryPlaneAndOrientation) {
    // A comb: 3 x 1 with two notches of 1/2 x 1/2, whose fan would cover the notches.
    const std::vector<std::pair<float, float>> comb = {{0, 0},       {3, 0},    {3, 1}, {2.5f, 1},
                                                       {2.5f, 0.5f}, {2, 0.5f}, {2, 1}, {1.5f, 1},
                                                       {1.5f, 0.5f}, {1, 0.5f}, {1, 1}, {0, 1}};
    for (int plane = 0; plane < 3; ++plane) {
        for (const bool reversed : {false, true}) {
            std::vector<Vec3> points;
            for (const auto& [u, v] : comb) {
                Vec3 p{};
                p[plane] = 0.25f;
                p[(plane + 1) % 3] = u;
                p[(plane + 2) % 3] = v;
                points.push_back(p);
            }
            if (reversed) points = {points.rbegin(), points.rend()};
            expect_tiling(points, 2.5f);
        }
    }
}

TEST(Triangulate, TilesARingWithASlit) {
    expect_tiling({{0, 0, 0},
                   {3, 0, 0},
                   {3, 3, 0},
                   {0, 3, 0},
                   {0, 0, 0},
                   {1, 1, 0},
                   {1, 2, 0},
                   {2, 2, 0},
                   {2, 1, 0},
                   {1, 1, 0}},
                  8.0f);
}

TEST(Triangulate, EndsForPolygonsWithoutEars) {
    const std::vector<Vec3> bow_tie = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_EQ(triangulate(bow_tie, all_corners(bow_tie)).size(), 2u);
    const std::vector<Vec3> points(100, Vec3{1, 2, 3});
    EXPECT_EQ(triangulate(points, all_corners(points)).size(), 98u);
    const std::vector<Vec3> broken(5, Vec3{NAN, INFINITY, 0});
    EXPECT_EQ(triangulate(broken, all_corners(broken)).size(), 3u);
}

}  // namespace
}  // namespace ctpbench
