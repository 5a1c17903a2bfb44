// Blocks of the index buffer: what one thread counts and scatters at a time when paths are sorted or
// compacted.
#pragma once

#include <cstdint>

#include "platform.h"

namespace ctpbench {

inline constexpr std::uint32_t kReorderBlock = 8192;

struct BlockRange {
    std::uint32_t begin, end;
};

CTP_INLINE std::uint32_t block_count(std::uint32_t count) {
    return (count + kReorderBlock - 1) / kReorderBlock;
}

CTP_INLINE BlockRange block_range(std::uint32_t block, std::uint32_t count) {
    const std::uint32_t begin = block * kReorderBlock;
    return {begin, count - begin < kReorderBlock ? count : begin + kReorderBlock};
}

}  // namespace ctpbench
