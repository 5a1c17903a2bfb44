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

}  // namespace ctpbench
