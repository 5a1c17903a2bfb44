#include "backends/cuda.h"

#include "backends/cuda_check.cuh"

namespace ctpbench {
namespace {

__global__ void nothing() {}

// Whether the program holds code that this device runs shows only when it is asked to.
std::string code_obstacle(const cudaDeviceProp& device, int number) {
    cudaFuncAttributes attributes;
    const cudaError_t status = cudaFuncGetAttributes(&attributes, nothing);
    if (status == cudaSuccess) return {};
    cudaGetLastError();
    return "device " + std::to_string(number) + " (" + device.name + ") runs code for architecture " +
           std::to_string(device.major) + std::to_string(device.minor) +
           ", which this program holds none of (" + cudaGetErrorString(status) +
           "); build with -DCMAKE_CUDA_ARCHITECTURES=" + std::to_string(device.major) +
           std::to_string(device.minor);
}

}  // namespace

int cuda_toolkit() { return CUDART_VERSION; }

std::string cuda_obstacle(int number) {
    int count = 0;
    cudaError_t status = cudaGetDeviceCount(&count);
    if (status != cudaSuccess) {
        cudaGetLastError();
        return std::string("no usable CUDA device or driver: ") + cudaGetErrorString(status) + " (error " +
               std::to_string(static_cast<int>(status)) + "); look at nvidia-smi, or choose --backend cpu";
    }
    if (number < 0 || number >= count)
        return "there is no CUDA device " + std::to_string(number) + ", the machine has " +
               std::to_string(count) + "; choose another with --device";
    cudaDeviceProp device;
    status = cudaGetDeviceProperties(&device, number);
    if (status == cudaSuccess) status = cudaSetDevice(number);
    if (status == cudaSuccess) status = cudaFree(nullptr);  // creates the context
    if (status != cudaSuccess) {
        cudaGetLastError();
        return "device " + std::to_string(number) + " cannot be used: " + cudaGetErrorString(status) +
               "; look at nvidia-smi, or choose another with --device";
    }
    return code_obstacle(device, number);
}

CudaDevice use_cuda_device(int number) {
    if (const std::string why = cuda_obstacle(number); !why.empty())
        throw Error(ExitCode::no_backend, "backend cuda: error: " + why);
    cudaDeviceProp properties;
    check_cuda(cudaGetDeviceProperties(&properties, number), "asking for the device's properties");
    CudaDevice device;
    device.number = number, device.name = properties.name;
    device.multiprocessors = properties.multiProcessorCount;
    device.architecture = 10 * properties.major + properties.minor;
    device.memory_bytes = properties.totalGlobalMem,
    device.l2_bytes = static_cast<std::size_t>(properties.l2CacheSize);
    device.ecc = properties.ECCEnabled != 0;
    const auto ask = [&](int& value, cudaDeviceAttr attribute) {
        check_cuda(cudaDeviceGetAttribute(&value, attribute, number), "asking for the device's clocks");
    };
    ask(device.clock_khz, cudaDevAttrClockRate), ask(device.memory_clock_khz, cudaDevAttrMemoryClockRate);
    check_cuda(cudaDriverGetVersion(&device.driver), "asking for the driver's version");
    check_cuda(cudaRuntimeGetVersion(&device.runtime), "asking for the runtime's version");
    return device;
}

CudaMemory cuda_memory() {
    // The driver keeps a stack for each thread that the device can hold, sized by the kernel with the
    // largest, and takes it when that kernel is first launched. Ours need less than a KiB
    // (scripts/cuda_resources).
    constexpr std::size_t stack = std::size_t{1} << 10, code = std::size_t{64} << 20;
    CudaMemory memory;
    check_cuda(cudaMemGetInfo(&memory.free, &memory.total), "asking for the device's memory");
    cudaDeviceProp properties;
    int number = 0;
    check_cuda(cudaGetDevice(&number), "asking for the device");
    check_cuda(cudaGetDeviceProperties(&properties, number), "asking for the device's properties");
    const auto threads = static_cast<std::size_t>(properties.multiProcessorCount) *
                         static_cast<std::size_t>(properties.maxThreadsPerMultiProcessor);
    memory.beside = threads * stack + code;
    return memory;
}

}  // namespace ctpbench
