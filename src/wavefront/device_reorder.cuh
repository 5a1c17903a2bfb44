// What moves indices from one buffer to another on a device, and what keeps count of them there.
#pragma once

#include <utility>

#include "backends/cuda_blocks.cuh"
#include "backends/cuda_launch.cuh"
#include "kernels/tile_wide.h"

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
    launch_blocks(stream, 1, TileScan{in.count, in.places, By::keys, offsets}, name);
    launch_blocks(stream, tile_count(most), TileMove<By>{in, index, moved}, name);
}

// The same by shade key, of which the input says how many there are.
template <std::uint32_t... numbers>
bool sort_by_few_keys(cudaStream_t stream, std::uint32_t most, const WideTileInput& in,
                      const std::uint32_t* index, std::uint32_t* moved, std::uint32_t* offsets,
                      std::integer_sequence<std::uint32_t, numbers...>) {
    return ((in.keys == numbers + 2 &&
             (reorder<ByShadeKey<numbers + 2>>(stream, most, {in.keys_of, in.count, in.places}, index, moved,
                                               offsets, "sort"),
              true)) ||
            ...);
}
inline void sort_by_shade_key(cudaStream_t stream, std::uint32_t most, const WideTileInput& in,
                              const std::uint32_t* index, std::uint32_t* moved, std::uint32_t* offsets) {
    // Two keys are the fewest.
    if (sort_by_few_keys(stream, most, in, index, moved, offsets,
                         std::make_integer_sequence<std::uint32_t, kPackedKeys - 1>{}))
        return;
    launch_blocks(stream, tile_count(most), WideTileCount{in}, "sort");
    launch_blocks(stream, 1, TileScan{in.count, in.places, in.keys, offsets}, "sort");
    launch_blocks(stream, tile_count(most), WideTileMove{in, index, moved}, "sort");
}

}  // namespace ctpbench
