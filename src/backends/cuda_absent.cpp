// Stands in for the CUDA backend in a program that was built without it.
#include "backends/cuda.h"
#include "base/error.h"

namespace ctpbench {

int cuda_toolkit() { return 0; }

std::string cuda_obstacle(int) {
    return "this program was built without CUDA; build it where CMake finds nvcc, or choose --backend cpu";
}

CudaDevice use_cuda_device(int number) {
    throw Error(ExitCode::no_backend, "backend cuda: error: " + cuda_obstacle(number));
}

CudaMemory cuda_memory() { return {}; }

}  // namespace ctpbench
