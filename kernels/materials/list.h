// The list of material types. A type's position is its tag in scenes, and its name is what scene files call
// it. A contender that is compiled for some of them only counts tags and sort keys among those.
#pragma once

#include "../type_list.h"
#include "emissive.h"
#include "matte.h"
#include "mirror.h"
#include "plastic.h"

namespace ctpbench {

template <class Color>
using MaterialsOf = TypeList<MatteOf<Color>, PlasticOf<Color>, Mirror, Emissive>;

using Materials = MaterialsOf<DiffuseColor>;
using UntexturedMaterials = MaterialsOf<ConstantColor>;

namespace detail {
template <class T>
struct MaterialType : std::integral_constant<std::uint32_t, index_of<T, Materials>> {};
template <template <class> class T>
struct MaterialType<T<ConstantColor>>
    : std::integral_constant<std::uint32_t, index_of<T<ConstantColor>, UntexturedMaterials>> {};
}  // namespace detail

// How scenes refer to the type.
template <class T>
inline constexpr std::uint32_t material_type = detail::MaterialType<T>::value;

// Which materials a contender is compiled for.
struct MaterialTypes {
    std::uint32_t mask = whole_mask<Materials>;  // bit i is that of the type i
    bool textured = true;                        // whether any of them may have a texture

    bool operator==(const MaterialTypes&) const = default;
};

namespace detail {
template <class... Ts, class... Us>
constexpr std::uint32_t differing(TypeList<Ts...>, TypeList<Us...>) {
    std::uint32_t mask = 0, bit = 1;
    ((mask |= std::is_same_v<Ts, Us> ? 0 : bit, bit <<= 1), ...);
    return mask;
}
}  // namespace detail

// The types that look at a texture: with others alone, there is no difference.
inline constexpr std::uint32_t kTexturable = detail::differing(Materials{}, UntexturedMaterials{});

}  // namespace ctpbench
