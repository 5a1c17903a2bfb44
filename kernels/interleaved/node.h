// The 8-wide tree in one array of bytes: nodes, and what leaves hold. A word names either by its place and
// says which it is, so that a step needs to know nothing else of where it goes.
#pragma once

#include <cstddef>
#include <cstdint>

#include "../platform.h"

namespace ctpbench {

inline constexpr std::uint32_t kWide = 8;

// Bits 5 and up of a word are an offset in bytes: everything lies on 32-byte boundaries, within 4 GiB. Bits 0
// to 2 say what is there; of a leaf, bits 3 and 4 how many more blocks it holds than the one named.
inline constexpr std::uint32_t kUnit = 32;
inline constexpr std::uint32_t kInner = 0;  // a WideNode
inline constexpr std::uint32_t kDone = 1;   // nothing: the ray has been everywhere
inline constexpr std::uint32_t kHit = 2;    // nothing; its place is taken by a list of rays (flight.h)
inline constexpr std::uint32_t kFirstLeaf =
    3;  // a leaf, of the first type if leaves hold one type; and so on
inline constexpr std::uint32_t kMaxLeafBlocks = 4;

CTP_INLINE std::uint32_t offset_of_word(std::uint32_t word) { return word & ~(kUnit - 1); }
CTP_INLINE std::uint32_t kind_of_word(std::uint32_t word) { return word & 7u; }
CTP_INLINE std::uint32_t more_blocks(std::uint32_t word) { return word >> 3 & 3u; }
CTP_INLINE std::uint32_t leaf_word_of(std::uint32_t offset, std::uint32_t kind, std::uint32_t blocks) {
    return offset | (blocks - 1) << 3 | kind;
}
inline constexpr std::uint32_t kOneBlock = 1u << 3;

struct alignas(64) WideNode {
    float bounds[3][2][kWide];      // by axis lo and hi; a child that is not there has lo > hi
    std::uint32_t children[kWide];  // words
    // For each of the 8 octants of directions 3 bits: the child in this place of that octant's order, from
    // the farthest to the nearest. Octant: bit 0 is set for a negative x, bit 1 for y, bit 2 for z.
    std::uint32_t order[kWide];
};
static_assert(sizeof(WideNode) == 256);

// Where a node has the plane that a direction crosses first, in bytes; the other one is at `^ kOtherPlane`.
inline constexpr std::uint32_t kOtherPlane = kWide * sizeof(float);
CTP_INLINE std::uint32_t first_plane(std::uint32_t axis, bool negative) {
    return (2 * axis + negative) * kOtherPlane;
}

}  // namespace ctpbench
