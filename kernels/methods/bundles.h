// The tests of geometry of a run, as one type. A bundle names all of them for whole runs; a strategy differs
// from another in dispatch only, with whatever bundle.
#pragma once

#include "lists.h"

namespace ctpbench {

// What the intersect stage is compiled for.
template <class TriangleTest, class SphereTest, class BoxTest>
struct Tests {
    using Triangle = TriangleTest;
    using Sphere = SphereTest;
    using Box = BoxTest;
    // Whether hits are bit-identical whatever the tree. That takes a bound, whatever the angle, on how far
    // from the ray and from its own t the point lies that a primitive's test reports, and boxes widened by
    // it. No test that takes t from the triangle's plane has one: not in float64 either, where t is rounding
    // alone for a ray in that plane. The textbook sphere finds points that are not on the sphere.
    static constexpr bool exact = std::is_same_v<TriangleTest, WatertightTriangle> &&
                                  !std::is_same_v<SphereTest, TextbookSphere> &&
                                  std::is_same_v<BoxTest, PaddedBox>;
    static constexpr bool float64 =
        std::is_same_v<TriangleTest, MoellerTrumbore64> || std::is_same_v<SphereTest, StableSphere64>;
    static constexpr bool excludes = false;  // whether a ray leaves out the primitive that it comes from
};

// The default: hits are a function of scene and ray alone, and closed meshes have no gaps.
struct Watertight : Tests<WatertightTriangle, StableSphere, PaddedBox> {
    static constexpr const char* name = "watertight";
    using Offset = WaechterBinder;
};

// What the paper's library does. Rays can slip through shared edges, and miss distant spheres.
struct PaperMethods : Tests<MoellerTrumbore, TextbookSphere, PlainBox> {
    static constexpr const char* name = "paper";
    using Offset = ConstantEpsilon;
};

// What a renderer does that takes leaks for speed. The padded box is faster than the plain one: its planes
// are sign-indexed and cost a fused multiply-add each.
struct FastMethods : Tests<MoellerTrumbore, StableSphere, PaddedBox> {
    static constexpr const char* name = "fast";
    using Offset = WaechterBinder;
};

// Primitives in double precision, the tree in single.
struct Float64Methods : Tests<MoellerTrumbore64, StableSphere64, PaddedBox> {
    static constexpr const char* name = "float64";
    using Offset = WaechterBinder;
};

using MethodBundles = TypeList<Watertight, PaperMethods, FastMethods, Float64Methods>;

// The same tests for rays that leave out the primitive they come from (offset_exclude_id.h).
template <class Methods>
struct Excluding : Methods {
    static constexpr bool excludes = true;
};

namespace detail {
template <bool excludes>
struct ExcludedPrimitive {
    CTP_INLINE explicit ExcludedPrimitive(std::uint32_t) {}
    CTP_INLINE bool leaves_out(std::uint32_t) const { return false; }
};
template <>
struct ExcludedPrimitive<true> {
    std::uint32_t excluded;
    CTP_INLINE explicit ExcludedPrimitive(std::uint32_t id) : excluded(id) {}
    CTP_INLINE bool leaves_out(std::uint32_t id) const { return id == excluded; }
};
}  // namespace detail

// All that a traversal derives from a ray, once per ray.
template <class Methods>
struct RayContext : detail::ExcludedPrimitive<Methods::excludes> {
    typename Methods::Box::RaySetup box;
    typename Methods::Triangle::RaySetup triangle;
    typename Methods::Sphere::RaySetup sphere;

    // `extent` is the largest absolute coordinate of the scene's bounds. `excluded` is the primitive to leave
    // out, if the methods do such a thing.
    CTP_INLINE RayContext(const Ray& ray, float extent, std::uint32_t excluded = kNoPrimitive)
        : detail::ExcludedPrimitive<Methods::excludes>(excluded),
          box(Methods::Box::setup(ray, extent)),
          triangle(Methods::Triangle::setup(ray)),
          sphere(Methods::Sphere::setup(ray)) {}
};

}  // namespace ctpbench
