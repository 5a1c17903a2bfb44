// What a compiler's contraction of a b + c into one rounding does to tests of geometry. The same code is
// compiled twice: as everything is, and with contraction on under another name of the namespace
// (contracted.cpp), so that the two do not meet in one function. Includes kernels alone, for that reason.
#pragma once

#include "kernels/methods/lists.h"

namespace ctpbench {

struct ContractionCounts {
    int parallel_hit;  // by Moeller & Trumbore's test: rays along a triangle's plane that it says are hits
    int vertex_missed[2];  // by Pluecker's test, Woop's: rays at the vertex of a fan that hit none of it
};

// Numbers in [lo, hi) of a splitmix sequence.
struct ContractionRandom {
    std::uint64_t state;

    float uniform(float lo, float hi) {
        state += 0x9e3779b97f4a7c15u;
        std::uint64_t z = state;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return lo + (hi - lo) * static_cast<float>((z ^ (z >> 31)) >> 40) * 0x1p-24f;
    }
    Vec3 point(float lo, float hi) { return {uniform(lo, hi), uniform(lo, hi), uniform(lo, hi)}; }
};

template <class Test>
bool hits(const TriangleShape& s, Vec3 origin, Vec3 direction) {
    const Ray ray = {origin, direction, std::numeric_limits<float>::infinity()};
    Hit hit = no_hit(ray);
    Test::intersect(Test::shape(s), 0, Test::setup(ray), hit);
    return hit.primitive == 0;
}

inline constexpr int kContractionRays = 100000;

inline ContractionCounts count_contraction() {
    ContractionCounts counts{};
    ContractionRandom random{11};
    for (int i = 0; i < kContractionRays; ++i) {
        // A ray in the triangle's plane, its direction half an edge: their cross product is exactly 0, unless
        // one of its two products is rounded and the other is not.
        const TriangleShape s = {random.point(-1, 1), random.point(-1, 1), random.point(-1, 1)};
        const Vec3 edge = s.c - s.a;
        const float across = random.uniform(0, 1), before = random.uniform(1, 3);
        const Vec3 beside = s.a + (across * (s.b - s.a) - before * edge);
        counts.parallel_hit += hits<MoellerTrumbore>(s, beside, 0.5f * edge);

        // Four triangles about a vertex below the origin, which they enclose as seen from there.
        const Vec3 top = {random.uniform(-0.1f, 0.1f), random.uniform(-0.1f, 0.1f), -1.0f};
        const Vec3 rim[4] = {{1.0f + random.uniform(0, 1), random.uniform(-0.5f, 0.5f), -1.5f},
                             {random.uniform(-0.5f, 0.5f), 1.0f + random.uniform(0, 1), -1.5f},
                             {-1.0f - random.uniform(0, 1), random.uniform(-0.5f, 0.5f), -1.5f},
                             {random.uniform(-0.5f, 0.5f), -1.0f - random.uniform(0, 1), -1.5f}};
        const Vec3 origin = 0.1f * random.point(-1, 1);
        bool met[2] = {false, false};
        for (int k = 0; k < 4; ++k) {
            const TriangleShape fan = {top, rim[k], rim[(k + 1) % 4]};
            met[0] |= hits<Pluecker>(fan, origin, top - origin);
            met[1] |= hits<WatertightTriangle>(fan, origin, top - origin);
        }
        counts.vertex_missed[0] += !met[0], counts.vertex_missed[1] += !met[1];
    }
    return counts;
}

}  // namespace ctpbench
