// Runs block programs (kernels/tile.h) on the device.
#pragma once

#include <cstdint>

#include "backends/cuda_check.cuh"

namespace ctpbench {

namespace detail {
template <std::uint32_t phase, class Program>
__device__ __forceinline__ void run_phases(const Program& program, typename Program::Shared& shared,
                                           typename Program::Thread& thread) {
    if constexpr (phase < Program::phases) {
        if constexpr (phase > 0) __syncthreads();
        program.template run<phase>(blockIdx.x, threadIdx.x, shared, thread);
        run_phases<phase + 1>(program, shared, thread);
    }
}
}  // namespace detail

template <class Program>
__global__ void __launch_bounds__(Program::threads) block_kernel(const __grid_constant__ Program program) {
    __shared__ typename Program::Shared shared;
    if (program.idle(blockIdx.x)) return;
    typename Program::Thread thread;
    detail::run_phases<0>(program, shared, thread);
}

template <class Program>
void launch_blocks(cudaStream_t stream, std::uint32_t blocks, const Program& program, const char* name) {
    if (blocks == 0) return;
    block_kernel<<<blocks, Program::threads, 0, stream>>>(program);
    check_launch(name);
}

}  // namespace ctpbench
