// A tree of eight children a node as a traversal is given it.
#pragma once

#include "../bvh.h"
#include "node.h"

namespace ctpbench {

struct WideView {
    const std::byte* bytes = nullptr;  // null: there is nothing to hit
    std::uint32_t root = kDone;        // a word
    std::uint32_t stack = 0;           // entries that a ray's stack may come to hold
};

// The most that a tree of kMaxTreeDepth levels of eight can come to need, the bottom, and room to write
// beyond.
inline constexpr std::uint32_t kMaxStack = kMaxTreeDepth * (kWide - 1) + 1 + kWide;

// From one ray's stack to the next one's: an odd number of cache lines, so that stacks do not contend for the
// same sets of a cache.
constexpr std::uint32_t stack_stride(std::uint32_t entries) {
    return ((entries + kWide + 15) / 16 | 1u) * 16;
}

}  // namespace ctpbench
