// The binary tree that every single-ray strategy traverses: 32-byte nodes, as in the paper (Table 2).
#pragma once

#include <cstdint>

#include "box.h"

namespace ctpbench {

// Upper bound on a tree's depth (a lone root has depth 1). The builder keeps to it on any input, so a
// traversal stack of this many entries cannot overflow.
inline constexpr std::uint32_t kMaxTreeDepth = 64;

// A leaf word has room for this many types.
inline constexpr std::uint32_t kLeafTypes = 256;

// An inner node's children are nodes `first` and `first + 1`. A leaf holds `count()` consecutive
// entries from `first` on; `type()` is meaningful in trees built with single-type leaves.
struct alignas(32) BvhNode {
    float bounds[6];      // lo x, y, z, hi x, y, z
    std::uint32_t first;  // first child, or first entry of the leaf
    std::uint32_t leaf;   // 0 for an inner node, else type << 24 | count

    CTP_INLINE bool is_leaf() const { return leaf != 0; }
    CTP_INLINE std::uint32_t count() const { return leaf & 0xffffffu; }
    CTP_INLINE std::uint32_t type() const { return leaf >> 24; }
    CTP_INLINE static std::uint32_t leaf_word(std::uint32_t type, std::uint32_t count) {
        return type << 24 | count;
    }

    CTP_INLINE Box box() const {
        return {{bounds[0], bounds[1], bounds[2]}, {bounds[3], bounds[4], bounds[5]}};
    }
    CTP_INLINE void set_box(const Box& b) {
        bounds[0] = b.lo.x, bounds[1] = b.lo.y, bounds[2] = b.lo.z;
        bounds[3] = b.hi.x, bounds[4] = b.hi.y, bounds[5] = b.hi.z;
    }
};
static_assert(sizeof(BvhNode) == 32);

// bounds[offset], which is one of the axis' two planes: on a GPU chosen from registers, as element() does.
template <int axis>
CTP_INLINE float plane_of(const float (&bounds)[6], int offset) {
#if defined(__CUDA_ARCH__)
    return offset == axis ? bounds[axis] : bounds[axis + 3];
#else
    return bounds[offset];
#endif
}

// What a leaf entry names: the type's position in the list of primitives, and the element of that type.
struct PrimitiveRef {
    std::uint32_t type;
    std::uint32_t index;
};

}  // namespace ctpbench
