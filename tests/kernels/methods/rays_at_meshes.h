// Rays that tell triangle tests apart: at edges and vertices of a closed mesh, from inside. Any miss is a
// leak.
#pragma once

#include "kernels/methods/lists.h"
#include "support.h"

namespace ctpbench::test {

template <class Test>
Hit trace_all(const Mesh& mesh, const Ray& ray) {
    Hit hit = no_hit(ray);
    const auto setup = Test::setup(ray);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
        Test::intersect(Test::shape(mesh.triangle(i)), i, setup, hit);
    return hit;
}

enum class Aim { edges, vertices, interiors };

// Failures per million rays from inside a closed star-shaped mesh about `center`, whose radius is about
// `scale`. Targets and directions are rounded to float, so a ray at an edge passes some ulps beside it.
// Interiors stay a twentieth of the triangle away from its edges.
template <class Test>
double leaks(Aim aim, float scale = 1.0f, Vec3 center = {0, 0, 0}, int rays = 50000) {
    const Mesh mesh = star(2, scale, center, 3);
    Random random(5);
    int missed = 0;
    for (int i = 0; i < rays; ++i) {
        const TriangleShape t = mesh.triangle(static_cast<std::size_t>(i) % mesh.triangles.size());
        const Vec3 origin = center + 0.3f * scale * random.point(-1.0f, 1.0f);
        const float u = random.uniform(0.05f, 0.9f), v = (0.95f - u) * random.uniform(0.0f, 1.0f);
        const Vec3 at = aim == Aim::vertices ? t.a
                        : aim == Aim::edges  ? t.a + random.uniform(0.0f, 1.0f) * (t.b - t.a)
                                             : t.a + u * (t.b - t.a) + max(v, 0.05f) * (t.c - t.a);
        missed += trace_all<Test>(mesh, {origin, at - origin, kInfinity}).primitive == kNoPrimitive;
    }
    return 1e6 * missed / rays;
}

}  // namespace ctpbench::test
