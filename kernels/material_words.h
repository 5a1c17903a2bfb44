// Which material a primitive has: one word per triangle, and one for all spheres. The word names the
// material's type too, so that paths can be sorted by type without a look at the material itself. Types are
// counted among those that the contender is compiled for.
#pragma once

#include <cstdint>

#include "materials/list.h"
#include "ray.h"
#include "synthetic/types.h"

namespace ctpbench {

// Materials are numbered grouped by type, in the order of the list: those of one type are consecutive.
struct MaterialWord {
    std::uint32_t bits;  // type << 24 | number

    CTP_INLINE static MaterialWord make(std::uint32_t type, std::uint32_t number) {
        return {type << 24 | number};
    }
    CTP_INLINE std::uint32_t type() const { return bits >> 24; }
    CTP_INLINE std::uint32_t number() const { return bits & 0xffffffu; }
};
inline constexpr std::uint32_t kMaxMaterials = 1u << 24;

struct MaterialWords {
    const MaterialWord* of_triangle;
    std::uint32_t triangle_count;
    MaterialWord of_spheres;
    std::uint32_t types;  // how many there are

    CTP_INLINE MaterialWord of(std::uint32_t primitive) const {
        return primitive < triangle_count ? of_triangle[primitive] : of_spheres;
    }
    // What paths are told apart by before shading: the type of the material hit, or that nothing was hit.
    CTP_INLINE std::uint32_t miss_key() const { return types; }
    CTP_INLINE std::uint32_t keys() const { return types + 1; }
    CTP_INLINE std::uint32_t key_of(const Hit& hit) const {
        return hit.primitive == kNoPrimitive ? miss_key() : of(hit.primitive).type();
    }
};

// No contender is compiled for more types.
inline constexpr std::uint32_t kMaxMaterialTypes = kMaxSyntheticTypes;
inline constexpr std::uint32_t kMaxShadeKeys = kMaxMaterialTypes + 1;
static_assert(Materials::size <= kMaxMaterialTypes);

}  // namespace ctpbench
