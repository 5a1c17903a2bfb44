// What the program knows of CUDA devices, whether or not it was built with CUDA.
#pragma once

#include <cstddef>
#include <string>

namespace ctpbench {

struct CudaDevice {
    int number = 0;
    std::string name;  // as the driver calls it
    int multiprocessors = 0;
    int architecture = 0;  // 90: compute capability 9.0
    std::size_t memory_bytes = 0, l2_bytes = 0;
    int clock_khz = 0, memory_clock_khz = 0;  // highest
    int driver = 0, runtime = 0;              // 13000: CUDA 13.0
    bool ecc = false;
};

// Of the toolkit that the program was built with: 13000 is CUDA 13.0; 0 without one.
int cuda_toolkit();

// Why device `number` cannot be used here, and what to do; empty if it can. Never throws.
std::string cuda_obstacle(int number);

// Makes the device the one that this thread works on. Throws Error(no_backend) with its obstacle.
CudaDevice use_cuda_device(int number);

struct CudaMemory {
    std::size_t free = 0, total = 0;  // bytes
    std::size_t beside = 0;  // of those free, what the driver may yet take for itself: stacks and code
};

// Of the device that this thread works on.
CudaMemory cuda_memory();

}  // namespace ctpbench
