// Named sets of methods for whole runs. A bundle fixes the arithmetic; strategies differ in dispatch only.
#pragma once

#include "../type_list.h"
#include "box_padded.h"
#include "box_plain.h"
#include "sphere_stable.h"
#include "triangle_moeller_trumbore.h"
#include "triangle_watertight.h"

namespace ctpbench {

// The default: hits are a function of scene and ray alone, and closed meshes have no gaps.
struct Watertight {
    static constexpr const char* name = "watertight";
    static constexpr bool exact = true;  // hits are bit-identical whatever the tree
    using Triangle = WatertightTriangle;
    using Sphere = StableSphere;
    using Box = PaddedBox;
};

// What the paper's library does. Rays can slip through shared edges.
struct PaperMethods {
    static constexpr const char* name = "paper";
    static constexpr bool exact = false;
    using Triangle = MoellerTrumbore;
    using Sphere = StableSphere;
    using Box = PlainBox;
};

using MethodBundles = TypeList<Watertight, PaperMethods>;

// All that a traversal derives from a ray, once per ray.
template <class Methods>
struct RayContext {
    typename Methods::Box::RaySetup box;
    typename Methods::Triangle::RaySetup triangle;
    typename Methods::Sphere::RaySetup sphere;

    // `extent` is the largest absolute coordinate of the scene's bounds.
    CTP_INLINE RayContext(const Ray& ray, float extent)
        : box(Methods::Box::setup(ray, extent)),
          triangle(Methods::Triangle::setup(ray)),
          sphere(Methods::Sphere::setup(ray)) {}
};

}  // namespace ctpbench
