// What moves indices from one buffer to another on a device, and what keeps count of them there.
#pragma once

#include "backends/cuda_blocks.cuh"
#include "backends/cuda_launch.cuh"
#include "kernels/tile.h"

namespace ctpbench {

// The yardstick of sorting and compacting.
struct CopyIndex {
    const std::uint32_t* from;
    std::uint32_t* to;
    __device__ void operator()(std::uint32_t i) const { to[i] = from[i]; }
};

struct SetCount {
    std::uint32_t* count;
    std::uint32_t value;
    const std::uint32_t* copied;  // if not null, the value
    __device__ void operator()(std::uint32_t) const { *count = copied != nullptr ? *copied : value; }
};

// Three kernels; offsets and the entries moved stay on the device.
template <class By>
void reorder(cudaStream_t stream, std::uint32_t most, const TileInput<By>& in, const std::uint32_t* index,
             std::uint32_t* moved, std::uint32_t* offsets, const char* name) {
    launch_blocks(stream, tile_count(most), TileCount<By>{in}, name);
    launch_blocks(stream, 1, TileScan<By>{in, offsets}, name);
    launch_blocks(stream, tile_count(most), TileMove<By>{in, index, moved}, name);
}

}  // namespace ctpbench
