// The triangle primitive, in the form that the bundle's test wants.
#pragma once

#include "../methods/bundles.h"
#include "geometry.h"

namespace ctpbench {

template <class Methods>
struct Triangle {
    static constexpr const char* name = "triangle";

    typename Methods::Triangle::Shape shape;
    std::uint32_t id;

    static Triangle make(const GeometryView& g, std::uint32_t index) {
        return {Methods::Triangle::shape(g.triangle(index)), index};
    }

    CTP_INLINE void intersect(const RayContext<Methods>& ray, Hit& hit) const {
        if (ray.leaves_out(id)) return;
        Methods::Triangle::intersect(shape, id, ray.triangle, hit);
    }
};

}  // namespace ctpbench
