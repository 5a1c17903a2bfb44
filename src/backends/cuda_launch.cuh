// Runs a kernel's functor on the device: a thread for each index.
#pragma once

#include <cstdint>

#include "backends/cuda_check.cuh"

namespace ctpbench {

// `count` where it is null; else the device's own count, at most `count`, which no host ever sees.
struct DeviceCount {
    std::uint32_t count;
    const std::uint32_t* on_device = nullptr;

    __device__ std::uint32_t get() const { return on_device != nullptr ? *on_device : count; }
};

inline constexpr std::uint32_t kBlockThreads = 128;
#if !defined(CTPBENCH_MIN_BLOCKS)
#define CTPBENCH_MIN_BLOCKS 8
#endif

// Blocks that must fit on a multiprocessor at once, which bounds the registers of a thread. Numbers in
// float64 take two each: a kernel that says it computes in them has room for fewer blocks, or it would spill.
template <class Kernel>
constexpr int min_blocks() {
    if constexpr (requires { Kernel::float64; }) return Kernel::float64 ? 6 : CTPBENCH_MIN_BLOCKS;
    return CTPBENCH_MIN_BLOCKS;
}

template <class Kernel>
__global__ void __launch_bounds__(kBlockThreads, min_blocks<Kernel>())
    for_each_kernel(const __grid_constant__ Kernel kernel, const __grid_constant__ DeviceCount count) {
    const std::uint32_t i = blockIdx.x * kBlockThreads + threadIdx.x;
    if (i < count.get()) kernel(i);
}

// `name` is what the kernel is called in error messages.
template <class Kernel>
void launch_for_each(cudaStream_t stream, DeviceCount count, const Kernel& kernel, const char* name) {
    if (count.count == 0) return;
    for_each_kernel<<<(count.count + kBlockThreads - 1) / kBlockThreads, kBlockThreads, 0, stream>>>(kernel,
                                                                                                     count);
    check_launch(name);
}

}  // namespace ctpbench
