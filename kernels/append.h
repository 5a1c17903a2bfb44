// Appending to a list from many threads of a GPU at once: one atomic addition for all lanes of a warp that
// append to the same list just now.
#pragma once

#include <cstdint>

#include "platform.h"

#if defined(__CUDACC__)

namespace ctpbench {

// A place of its own for the calling lane; *count goes up by the number of lanes that have called.
__device__ __forceinline__ std::uint32_t next_place(std::uint32_t* count) {
    const unsigned lanes = __activemask();
    const unsigned peers = __match_any_sync(lanes, reinterpret_cast<unsigned long long>(count));
    const unsigned lane = threadIdx.x % 32, leader = __ffs(static_cast<int>(peers)) - 1;
    std::uint32_t first = 0;
    if (lane == leader) first = atomicAdd(count, static_cast<unsigned>(__popc(peers)));
    return __shfl_sync(peers, first, static_cast<int>(leader)) + __popc(peers & ((1u << lane) - 1));
}

}  // namespace ctpbench

#endif
