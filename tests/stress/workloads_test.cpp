// Stress workloads must be what they are said to be, or a method that passes them has shown nothing.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "base/error.h"
#include "oracle/exact.h"
#include "scene/content_hash.h"
#include "stress/edge_rays.h"
#include "stress/meshes.h"
#include "stress/registry.h"
#include "support.h"
#include "wavefront/scene_view.h"

namespace ctpbench {
namespace {

bool finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
bool same(const Ray& a, const Ray& b) { return a.origin == b.origin && a.direction == b.direction; }

TEST(StressWorkloads, AreFunctionsOfNameAndSeed) {
    std::set<std::string> names;
    for (const StressInfo& info : stress_workloads()) {
        EXPECT_TRUE(names.insert(info.name).second) << info.name;
        EXPECT_FALSE(info.provokes.empty());
        EXPECT_FALSE(info.kinds == StressKinds{}) << info.name;
        const StressWorkload one = make_stress(info.name, 1), again = make_stress(info.name, 1),
                             other = make_stress(info.name, 2);
        EXPECT_EQ(one.of_offsets(), info.kinds.offset) << info.name;
        EXPECT_EQ(content_hash(one.scene), content_hash(again.scene)) << info.name;
        bool seed_matters = false;
        for (std::uint32_t i = 0; i < 300; ++i) {
            if (one.of_offsets()) {
                const Departure a = one.departure(i), b = again.departure(i), c = other.departure(i);
                ASSERT_TRUE(a.primitive == b.primitive && a.point == b.point && a.direction == b.direction);
                ASSERT_TRUE(finite(a.point) && finite(a.normal) && finite(a.direction)) << info.name;
                ASSERT_LT(a.primitive, one.surfaces.size());
                EXPECT_NEAR(length(a.normal), 1.0f, 1e-6f);
                EXPECT_NEAR(length(a.direction), 1.0f, 1e-6f);
                EXPECT_GT(dot(a.normal, a.direction), 0.0f) << info.name;
                seed_matters |= !(a.direction == c.direction);
            } else {
                const Ray a = one.ray(i), b = again.ray(i);
                ASSERT_TRUE(same(a, b)) << info.name << " " << i;
                ASSERT_TRUE(finite(a.origin) && finite(a.direction)) << info.name << " " << i;
                ASSERT_GT(length(a.direction), 0.0f) << info.name << " " << i;
                seed_matters |= !same(a, other.ray(i));
            }
        }
        EXPECT_TRUE(seed_matters) << info.name;
    }
}

TEST(StressWorkloads, AnUnknownNameListsTheChoices) {
    try {
        make_stress("edgy", 1);
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.code(), ExitCode::usage);
        EXPECT_NE(std::string(e.what()).find("needles"), std::string::npos);
    }
}

// Every edge belongs to two triangles, which run along it in opposite directions.
void expect_closed(const Mesh& mesh, const std::string& name) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
    for (const auto& [edge, n] : edges) {
        EXPECT_EQ(n, 1) << name;
        EXPECT_EQ(edges.count({edge.second, edge.first}), 1u) << name;
    }
}

TEST(StressMeshes, StarsAreClosedAndStarShapedWhereverTheyAre) {
    const struct {
        int subdivisions;
        float radius;
        Vec3 center;
    } places[] = {{4, 1, {0, 0, 0}},
                  {4, 64, {1.5e5f, -1.5e5f, 0.75e5f}},
                  {3, 256, {3e6f, -3e6f, 1.5e6f}},
                  {4, 1e-6f, {0, 0, 0}}};
    for (const auto& p : places) {
        const Mesh mesh = star_mesh(p.subdivisions, p.radius, p.center, 0.25f, 1);
        EXPECT_EQ(mesh.triangles.size(), 8u << (2 * p.subdivisions));
        expect_closed(mesh, "star");
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const TriangleShape t = mesh.triangle(i);
            double v[3][3];
            for (int k = 0; k < 3; ++k)
                for (int a = 0; a < 3; ++a)
                    v[k][a] = double{(k == 0 ? t.a : k == 1 ? t.b : t.c)[a]} - p.center[a];
            const double volume = v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) -
                                  v[0][1] * (v[1][0] * v[2][2] - v[1][2] * v[2][0]) +
                                  v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
            EXPECT_GT(volume, 0.0) << "radius " << p.radius << ", triangle " << i;
        }
    }
    expect_closed(tube_mesh(64, 1e-3f, 10.0f), "tube");
}

TEST(StressMeshes, NeedlesAreTenThousandToOne) {
    const Mesh tube = tube_mesh(64, 1e-3f, 10.0f);
    for (std::size_t i = 0; i < 2 * 63; ++i) {
        const TriangleShape t = tube.triangle(i);
        const float longest = std::max({length(t.b - t.a), length(t.c - t.b), length(t.a - t.c)});
        const float area = 0.5f * length(cross(t.b - t.a, t.c - t.a));
        EXPECT_NEAR(longest * longest / (2.0f * area), 1e4f, 2e2f);
    }
}

// The ray's line passes within a few ulps of what it is aimed at.
TEST(StressWorkloads, RaysPassWhatTheyAreAimedAt) {
    for (const char* name : {"edges", "vertices", "edges_x1e-6", "vertices_x1e6", "cube_vertices"}) {
        const StressWorkload w = make_stress(name, 3);
        const bool vertices = std::string(name).find("vertices") != std::string::npos;
        for (std::uint32_t i = 0; i < 200; ++i) {
            const Ray ray = w.ray(i);
            int touched = 0;
            for (std::size_t t = 0; t < w.scene.mesh.triangles.size(); ++t) {
                const ExactHit hit = exact_hit(w.scene.mesh.triangle(t), ray);
                touched += std::fabs(hit.margin) <= 4.0 * hit.unit && hit.t > 0.0;
            }
            EXPECT_GE(touched, vertices ? 3 : 2) << name << " ray " << i;
        }
    }
}

TEST(StressWorkloads, AxisParallelRaysHaveZeroComponentsInPlanesOfTheGrid) {
    const StressWorkload w = make_stress("axis_parallel", 1);
    for (std::uint32_t i = 0; i < 200; ++i) {
        const Ray ray = w.ray(i);
        int zeros = 0, in_planes = 0;
        for (int a = 0; a < 3; ++a) {
            zeros += ray.direction[a] == 0.0f;
            in_planes += ray.direction[a] == 0.0f && std::fmod(ray.origin[a], 0.25f) == 0.0f;
        }
        EXPECT_EQ(zeros, 2);
        EXPECT_GE(in_planes, 1);
    }
}

TEST(StressWorkloads, DeparturesStartOnTheirPrimitive) {
    for (const StressInfo& info : stress_workloads()) {
        if (!info.kinds.offset) continue;
        const StressWorkload w = make_stress(info.name, 2);
        for (std::uint32_t i = 0; i < 200; ++i) {
            const Departure d = w.departure(i);
            double distance = 0.0, size = 0.0;
            if (w.scene.spheres.empty()) {
                // Along the normal, from outside: the ideal point is where a ray meets the triangle.
                std::array<double, 3> from{}, along{};
                for (std::size_t a = 0; a < 3; ++a) {
                    along[a] = -double{d.normal[static_cast<int>(a)]};
                    from[a] = d.exact[a] - along[a];
                }
                const ExactHit hit = exact_hit(w.scene.mesh.triangle(d.primitive), {from, along});
                EXPECT_GE(hit.margin, -1e-12) << info.name;
                distance = std::fabs(hit.t - 1.0), size = 1.0;
            } else {
                const SphereShape& s = w.scene.spheres[0];
                for (int a = 0; a < 3; ++a)
                    distance += std::pow(d.exact[static_cast<std::size_t>(a)] - s.center[a], 2);
                distance = std::fabs(std::sqrt(distance) - s.radius), size = s.radius;
            }
            EXPECT_LE(distance, 1e-9 * size) << info.name << " " << i;
        }
    }
}

TEST(EdgeRays, AreAimedAtInnerEdgesOfWhatIsSeen) {
    // Two triangles that share an edge, and one that stands alone.
    Scene scene;
    scene.materials.push_back({});
    scene.mesh.positions = {{0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 1, 0},
                            {0, -1, 0}, {5, 5, 0}, {6, 5, 0},  {5, 6, 0}};
    scene.mesh.triangles = {{0, 1, 2}, {4, 5, 3}, {6, 7, 8}};
    scene.mesh.material = {0, 0, 0};
    const std::vector<Sighting> sightings{{{0.3f, 0.2f, -2}, 0}, {{-0.1f, 0.4f, -3}, 1}, {{5, 5, -1}, 2}};
    const std::vector<Ray> rays = edge_rays(scene, sightings, 4, 1000);
    ASSERT_EQ(rays.size(), 1000u);
    int vertices = 0;
    for (const Ray& ray : rays) {
        EXPECT_FALSE(ray.origin == sightings[2].origin) << "none of its edges is an inner one";
        const ExactHit a = exact_hit(scene.mesh.triangle(0), ray), b = exact_hit(scene.mesh.triangle(1), ray);
        EXPECT_LE(std::fabs(a.margin), 4.0 * a.unit);
        EXPECT_LE(std::fabs(b.margin), 4.0 * b.unit);
        vertices += std::fabs(ray.origin.y + ray.direction.y) == 1.0f;
    }
    EXPECT_NEAR(vertices / 1000.0, 0.25, 0.05);
    const std::vector<Ray> fewer = edge_rays(scene, sightings, 4, 10);
    for (std::size_t i = 0; i < fewer.size(); ++i) EXPECT_TRUE(same(fewer[i], rays[i]));
    EXPECT_TRUE(edge_rays(scene, {{sightings[2]}}, 4, 10).empty());
}

}  // namespace
}  // namespace ctpbench
