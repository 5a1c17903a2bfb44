// Triangles of synthetic types: all have the default methods' test, and vertices in a unit of their own. Hits
// are those of plain triangles, bit for bit, unless coordinates are denormal.
#pragma once

#include "../primitives/list.h"
#include "types.h"

namespace ctpbench {

template <int number, bool large>
struct SyntheticTriangle : Ballast<large> {
    using Test = Watertight::Triangle;
    static constexpr float unit = synthetic_unit<number>;

    Vec3 vertex[3];  // in units
    std::uint32_t id;

    static SyntheticTriangle make(const GeometryView& g, std::uint32_t index) {
        const TriangleShape t = g.triangle(index);
        SyntheticTriangle s{};
        s.vertex[0] = t.a * (1.0f / unit), s.vertex[1] = t.b * (1.0f / unit),
        s.vertex[2] = t.c * (1.0f / unit);
        s.id = index;
        return s;
    }

    CTP_INLINE void intersect(const RayContext<Watertight>& ray, Hit& hit) const {
        const TriangleShape t{vertex[0] * unit, vertex[1] * unit, vertex[2] * unit};
        Test::intersect(Test::shape(t), id, ray.triangle, hit);
    }
};

template <int listed, bool large>
using SyntheticPrimitives = SyntheticList<SyntheticTriangle, listed, large>;

namespace detail {
template <int number, bool large>
struct PrimitiveTag<SyntheticTriangle<number, large>> {
    static constexpr std::uint32_t value = number;
};
}  // namespace detail

}  // namespace ctpbench
