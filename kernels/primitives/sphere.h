// The sphere primitive, in the form that the bundle's test wants.
#pragma once

#include "../methods/bundles.h"
#include "geometry.h"

namespace ctpbench {

template <class Methods>
struct Sphere {
    static constexpr const char* name = "sphere";

    typename Methods::Sphere::Shape shape;
    std::uint32_t id;

    static Sphere make(const GeometryView& g, std::uint32_t index) {
        return {Methods::Sphere::shape(g.spheres[index]), g.first_sphere() + index};
    }

    CTP_INLINE void intersect(const RayContext<Methods>& ray, Hit& hit) const {
        if (ray.leaves_out(id)) return;
        Methods::Sphere::intersect(shape, id, ray.sphere, hit);
    }
};

}  // namespace ctpbench
