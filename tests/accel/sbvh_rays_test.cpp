// Rays through the tree against rays against every primitive, both in double: the hits must be the same.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/accel/check_tree.h"
#include "tests/accel/soups.h"

namespace ctpbench::test {
namespace {

struct DoubleRay {
    Point origin, direction;
};

struct DoubleHit {
    double t = std::numeric_limits<double>::infinity();
    std::uint32_t index = 0xffffffffu;

    void accept(double candidate, std::uint32_t i) {
        if (candidate > 0 && (candidate < t || (candidate == t && i < index))) t = candidate, index = i;
    }
};

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Point to_double(Vec3 v) { return {v.x, v.y, v.z}; }

// Moeller and Trumbore's test; not positive if missed.
double intersect(const TriangleShape& t, const DoubleRay& ray) {
    constexpr double miss = -1;
    const Point e1 = minus(to_double(t.b), to_double(t.a)), e2 = minus(to_double(t.c), to_double(t.a));
    const Point p = cross(ray.direction, e2), s = minus(ray.origin, to_double(t.a)), q = cross(s, e1);
    const double det = dot(e1, p), u = dot(s, p) / det, v = dot(ray.direction, q) / det;
    return det != 0 && u >= 0 && v >= 0 && u + v <= 1 ? dot(e2, q) / det : miss;
}

// Widened by double's rounding errors alone: what the builder rounds off wrongly shows.
bool meets(const Box& box, const DoubleRay& ray, double t_max) {
    double near = 0, far = t_max;
    for (int a = 0; a < 3; ++a) {
        const double pad = 1e-12 * (std::fabs(ray.origin[a]) + std::fabs(box.lo[a]) + std::fabs(box.hi[a]));
        const double lo = (box.lo[a] - pad - ray.origin[a]) / ray.direction[a];
        const double hi = (box.hi[a] + pad - ray.origin[a]) / ray.direction[a];
        near = std::fmax(near, std::fmin(lo, hi));
        far = std::fmin(far, std::fmax(lo, hi));
    }
    return near <= far * (1 + 1e-12);
}

DoubleHit traverse(const Scene& scene, const Tree& tree, const DoubleRay& ray) {
    DoubleHit hit;
    std::array<std::uint32_t, kMaxTreeDepth> stack;
    std::size_t top = 0;
    stack[top++] = 0;
    while (top > 0) {
        const BvhNode& node = tree.nodes[stack[--top]];
        if (!meets(node.box(), ray, hit.t)) continue;
        if (node.is_leaf()) {
            for (std::uint32_t i = node.first; i < node.first + node.count(); ++i) {
                const std::uint32_t index = tree.refs[i].index;
                hit.accept(intersect(scene.mesh.triangle(index), ray), index);
            }
        } else {
            stack[top++] = node.first + 1;
            stack[top++] = node.first;
        }
    }
    return hit;
}

// Half of the rays aim at a point of a primitive, so that edges of split references are met.
void expect_no_hit_lost(const Scene& scene, const SbvhSettings& settings, Vec3 center, float scale,
                        int rays) {
    const Tree tree = build_sbvh(ScenePrimitives(scene), settings);
    const auto n = static_cast<std::uint32_t>(scene.mesh.triangles.size());
    Random random(99);
    int lost = 0, hits = 0;
    for (int k = 0; k < rays; ++k) {
        const Vec3 origin = center + (1.5f * scale) * random.point(-1, 1);
        Vec3 target = center + scale * random.point(-1, 1);
        if (k % 2) {
            const TriangleShape t =
                scene.mesh.triangle(static_cast<std::uint32_t>(random.uniform(0, 0.999f) * n));
            const float u = random.uniform(0, 1), v = random.uniform(0, 1 - u);
            target = t.a + u * (t.b - t.a) + v * (t.c - t.a);
        }
        const DoubleRay ray{to_double(origin), minus(to_double(target), to_double(origin))};
        DoubleHit brute;
        for (std::uint32_t i = 0; i < n; ++i) brute.accept(intersect(scene.mesh.triangle(i), ray), i);
        const DoubleHit tree_hit = traverse(scene, tree, ray);
        hits += brute.index != 0xffffffffu;
        lost += tree_hit.index != brute.index || !(tree_hit.t == brute.t);
    }
    EXPECT_EQ(lost, 0);
    EXPECT_GT(hits, rays / 4);
}

TEST(SbvhRays, SplitNeedlesLoseNoHit) {
    SbvhSettings eager = SbvhSettings::quality();
    eager.alpha = 0;
    eager.reference_budget = 8;
    eager.max_leaf = 1;
    for (const Vec3 center : {Vec3{0, 0, 0}, Vec3{1e4f, 1e4f, -1e4f}}) {
        const Scene scene = needles(300, center, 1, 5);
        for (const SbvhSettings& s : {SbvhSettings::quality(), SbvhSettings::paper(), eager}) {
            expect_no_hit_lost(scene, s, center, 1, 5000);
        }
    }
}

}  // namespace
}  // namespace ctpbench::test
