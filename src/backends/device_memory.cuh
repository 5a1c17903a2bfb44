// Memory of a device, with one owner. All of it is allocated here, through a DevicePlace.
#pragma once

#include <cstddef>
#include <utility>

#include "backends/cuda_check.cuh"

namespace ctpbench {

class DeviceMemory {
public:
    DeviceMemory() = default;
    // Throws Error(no_backend) with the bytes needed and free. The bytes are not initialised.
    explicit DeviceMemory(std::size_t bytes) : bytes_(bytes) {
        if (bytes == 0) return;
        const cudaError_t status = cudaMalloc(&data_, bytes);
        if (status == cudaErrorMemoryAllocation) {
            cudaGetLastError();
            std::size_t free = 0, total = 0;
            check_cuda(cudaMemGetInfo(&free, &total), "asking for the device's memory");
            throw Error(ExitCode::no_backend,
                        "backend cuda: error: the device's memory is too small: " + std::to_string(bytes) +
                            " bytes needed, " + std::to_string(free) + " of " + std::to_string(total) +
                            " free; use fewer pixels, fewer spheres or a smaller batch_rays");
        }
        check_cuda(status, "allocating device memory");
    }
    DeviceMemory(DeviceMemory&& o) noexcept
        : data_(std::exchange(o.data_, nullptr)), bytes_(std::exchange(o.bytes_, 0)) {}
    DeviceMemory& operator=(DeviceMemory&& o) noexcept {
        std::swap(data_, o.data_), std::swap(bytes_, o.bytes_);
        return *this;
    }
    ~DeviceMemory() { cudaFree(data_); }

    void* data() const { return data_; }
    std::size_t bytes() const { return bytes_; }

private:
    void* data_ = nullptr;
    std::size_t bytes_ = 0;
};

}  // namespace ctpbench
