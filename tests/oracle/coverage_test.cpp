// Where a surface goes on, and where it ends.
#include "oracle/coverage.h"

#include <gtest/gtest.h>

#include "oracle/check.h"
#include "support.h"
#include "wavefront/scene_view.h"

namespace ctpbench {
namespace {

using test::kInfinity;

// A fan of six triangles about a center, which is lifted by `height`; `missing` of them are left out.
Scene fan(float height, int missing) {
    Scene scene;
    scene.materials.push_back({});
    scene.mesh.positions = {{0, 0, height}};
    for (int i = 0; i < 6; ++i) {
        const float angle = 1.0471975512f * static_cast<float>(i);
        scene.mesh.positions.push_back({std::cos(angle), std::sin(angle), 0});
    }
    for (std::uint32_t i = 0; i + static_cast<std::uint32_t>(missing) < 6; ++i) {
        scene.mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % 6});
        scene.mesh.material.push_back(0);
    }
    return scene;
}

bool covered(const Scene& scene, std::uint32_t id, Vec3 origin, Vec3 direction) {
    const SceneView view(scene);
    const Judge judge(view.geometry());
    const ExactRay ray(Ray{origin, direction, kInfinity});
    return judge.surface_goes_on(id, judge.exact(id, ray), ray);
}

TEST(Coverage, AClosedFanCoversItsCenterAndAnOpenOneDoesNot) {
    for (std::uint32_t id = 0; id < 6; ++id) EXPECT_TRUE(covered(fan(0.5f, 0), id, {0, 0, 5}, {0, 0, -1}));
    for (std::uint32_t id = 0; id < 5; ++id) EXPECT_FALSE(covered(fan(0.5f, 1), id, {0, 0, 5}, {0, 0, -1}));
}

// A doorway's corner seen along the wall: all that is missing is a sector of two degrees.
TEST(Coverage, AGapSeenNearlyEdgeOnIsAGap) {
    const Vec3 along = normalize(Vec3{1.0f, 0.2f, -0.03f});
    for (std::uint32_t id = 0; id < 5; ++id) {
        EXPECT_FALSE(covered(fan(0.0f, 1), id, -5.0f * along, along));
        EXPECT_TRUE(covered(fan(0.0f, 0), id, -5.0f * along, along));
    }
}

TEST(Coverage, AnEdgeOfTwoIsCoveredAndARimIsNot) {
    const Scene scene = fan(0.5f, 1);
    EXPECT_TRUE(covered(scene, 0, {0.25f, 0.4330127f, 5}, {0, 0, -1})) << "between the first and the second";
    EXPECT_FALSE(covered(scene, 0, {0.5f, 0, 5}, {0, 0, -1})) << "where the sixth is missing";
}

TEST(Coverage, ASilhouetteIsNotCovered) {
    // Seen from the side, both triangles at the ridge are on the same side of it, and so are all at the tip.
    const Scene ridge = fan(5.0f, 0);
    EXPECT_FALSE(covered(ridge, 1, {0, -9, 5}, {0, 1, 0}));
    EXPECT_FALSE(covered(ridge, 4, {0, -9, 5}, {0, 1, 0}));
}

TEST(Coverage, WhatIsBehindTheOriginDoesNotCover) {
    EXPECT_FALSE(covered(fan(0.0f, 0), 0, {0, 0, 0}, {0, 0, -1}));
    EXPECT_FALSE(covered(fan(0.0f, 0), 0, {0, 0, -1}, {0, 0, -1}));
}

TEST(Coverage, VerticesAreSharedByPosition) {
    Scene scene = fan(0.5f, 0);
    Scene apart = scene;
    apart.mesh.positions.clear();
    for (auto& t : apart.mesh.triangles)
        for (std::uint32_t& v : t) {
            apart.mesh.positions.push_back(scene.mesh.positions[v]);
            v = static_cast<std::uint32_t>(apart.mesh.positions.size() - 1);
        }
    EXPECT_TRUE(covered(apart, 3, {0, 0, 5}, {0, 0, -1}));
    const SceneView view(apart);
    const MeshAdjacency adjacency(view.geometry());
    EXPECT_EQ(adjacency.vertices(), 7u);
    EXPECT_EQ(adjacency.around(adjacency.vertex(0, 0)).size(), 6u);
}

}  // namespace
}  // namespace ctpbench
