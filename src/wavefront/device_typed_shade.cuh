// Shade kernels for the paths of one type, in a list whose place and length the device alone knows.
#pragma once

#include "backends/cuda_launch.cuh"
#include "kernels/append.h"
#include "kernels/dispatch/shade/typed_materials.h"

namespace ctpbench {

// In place of materials, for paths that hit nothing.
struct Outside {
    template <class Offset>
    CTP_INLINE PathFate shade(const ShadeBuffers& io, std::uint32_t slot) const {
        return shade_miss(io, slot);
    }
};

// Paths of one key in a sorted index, or in a sorted list of positions in an index that keeps its order.
template <class Shading, class Offset>
struct ShadeSortedRun {
    Shading shading;
    ShadeBuffers io;
    const std::uint32_t* positions;  // null: the index itself is sorted
    const std::uint32_t* offsets;    // where the key's paths begin, and where the next key's do

    __device__ std::uint32_t count() const { return offsets[1] - offsets[0]; }
    __device__ void operator()(std::uint32_t i) const {
        const std::uint32_t position = positions != nullptr ? positions[offsets[0] + i] : offsets[0] + i;
        io.fates[position] =
            static_cast<std::uint8_t>(shading.template shade<Offset>(io, io.index[position]));
    }
};

// Paths of one key in its queue; those that go on are kept.
template <class Shading, class Offset>
struct ShadeQueue {
    Shading shading;
    ShadeBuffers io;
    const std::uint32_t* slots;
    const std::uint32_t* length;
    std::uint32_t *survivors, *survivor_count, *dropped;

    __device__ std::uint32_t count() const { return *length; }
    __device__ void operator()(std::uint32_t i) const {
        const PathFate fate = shading.template shade<Offset>(io, slots[i]);
        if (fate == PathFate::goes_on) survivors[next_place(survivor_count)] = slots[i];
        if (fate == PathFate::dropped) atomicAdd(dropped, 1u);
    }
};

// A fixed number of blocks: the list's length is not known where they are launched, and empty blocks take
// time.
template <class Kernel>
__global__ void __launch_bounds__(kBlockThreads) counted_kernel(const __grid_constant__ Kernel kernel) {
    const std::uint32_t n = kernel.count(), step = gridDim.x * kBlockThreads;
    for (std::uint32_t i = blockIdx.x * kBlockThreads + threadIdx.x; i < n; i += step) kernel(i);
}

}  // namespace ctpbench
