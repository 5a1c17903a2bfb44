// Tests exchanged one by one: the combinations that are offered beside the bundles, with strategy `ctp`
// alone, to see what one test costs and buys. And what all combinations are called.
#pragma once

#include <string>

#include "bundles.h"

namespace ctpbench {

namespace detail {
template <class Triangle, class List>
struct WithTriangle;
template <class Triangle, class... Boxes>
struct WithTriangle<Triangle, TypeList<Boxes...>> {
    using type = TypeList<Tests<Triangle, StableSphere, Boxes>...>;
};
template <class List>
struct WithSpheres;
template <class... Spheres>
struct WithSpheres<TypeList<Spheres...>> {
    using type = TypeList<Tests<WatertightTriangle, Spheres, PaddedBox>...>;
};
}  // namespace detail

// A triangle test with each box test, and each sphere test with the default's others.
template <class Triangle>
using TestsWithTriangle = typename detail::WithTriangle<Triangle, BoxTests>::type;
using TestsWithSpheres = typename detail::WithSpheres<SphereTests>::type;

// The one combination for paths that exclude what they come from; with strategy `ctp` alone.
using ExcludingTests = Excluding<Watertight>;

// The name of the bundle that consists of these tests; null if there is none.
template <class Methods>
constexpr const char* bundle_of() {
    using Same = Tests<typename Methods::Triangle, typename Methods::Sphere, typename Methods::Box>;
    const char* name = nullptr;
    for_each_type(MethodBundles{}, [&](auto tag) {
        using Bundle = typename decltype(tag)::type;
        if (std::is_base_of_v<Same, Bundle>) name = Bundle::name;
    });
    return name;
}

// Whether strategies have these methods by way of a bundle.
template <class Methods>
inline constexpr bool is_bundle = !Methods::excludes && bundle_of<Methods>() != nullptr;

// What a combination of tests is called: `paper`, `pluecker+stable+padded`, `watertight+exclude_id`.
inline std::string tests_key(const std::string& triangle, const std::string& sphere, const std::string& box) {
    return triangle + "+" + sphere + "+" + box;
}
template <class Methods>
std::string tests_key() {
    const char* bundle = bundle_of<Methods>();
    const std::string key =
        bundle != nullptr ? bundle
                          : tests_key(Methods::Triangle::name, Methods::Sphere::name, Methods::Box::name);
    return Methods::excludes ? key + "+" + ExcludeId::name : key;
}

}  // namespace ctpbench
