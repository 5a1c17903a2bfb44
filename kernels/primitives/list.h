// The list of primitive types. A type's position is its tag in trees; a contender that is compiled for some
// of them only counts its own tags among those (primitive_tag() against index_of).
#pragma once

#include "sphere.h"
#include "triangle.h"

namespace ctpbench {

template <class Methods>
using Primitives = TypeList<Triangle<Methods>, Sphere<Methods>>;

namespace detail {
template <class T>
struct PrimitiveTag;
template <template <class> class T, class Methods>
struct PrimitiveTag<T<Methods>> {
    static constexpr std::uint32_t value = index_of<T<Methods>, Primitives<Methods>>;
};
}  // namespace detail

// How trees refer to the type.
template <class T>
inline constexpr std::uint32_t primitive_tag = detail::PrimitiveTag<T>::value;

// Calls f(TypeTag<T>{}) for the T of the list that trees refer to by this tag. A tag of none of them traps.
template <class List, class F>
void visit_by_tag(std::uint32_t tag, F&& f) {
    bool found = false;
    for_each_type(List{}, [&](auto type) {
        if (primitive_tag<typename decltype(type)::type> != tag) return;
        found = true;
        f(type);
    });
    if (!found) trap();
}

// Which primitives a contender is compiled for, of those that methods name: bit i is that of the type with
// tag i.
inline constexpr std::uint32_t kAllPrimitives = whole_mask<Primitives<Watertight>>;

CTP_INLINE std::uint32_t primitives_in(const GeometryView& geometry) {
    return (geometry.triangle_count > 0 ? 1u << primitive_tag<Triangle<Watertight>> : 0u) |
           (geometry.sphere_count > 0 ? 1u << primitive_tag<Sphere<Watertight>> : 0u);
}

}  // namespace ctpbench
