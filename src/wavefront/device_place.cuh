// A device's memory as the place of a layout: what is put there is copied once and freed with this.
#pragma once

#include <cstddef>
#include <vector>

#include "backends/device_array.cuh"
#include "kernels/dispatch/layout.h"

namespace ctpbench {

class DevicePlace {
public:
    template <class E>
    using Element = Slot<E>;

    template <class T>
    const T* operator()(const T* array, std::size_t n) const {
        return static_cast<const T*>(put(array, n * sizeof(T)));
    }
    template <class T>
    const Slot<T>* elements(const Array<T>& array) const {
        if constexpr (sizeof(Slot<T>) == sizeof(T)) {
            return static_cast<const Slot<T>*>(put(array.data(), array.size() * sizeof(T)));
        } else {
            Array<Slot<T>> padded(array.size());
            for (std::size_t i = 0; i < array.size(); ++i) padded[i].value = array[i];
            return static_cast<const Slot<T>*>(put(padded.data(), padded.size() * sizeof(Slot<T>)));
        }
    }
    // Not initialised.
    void* reserve(std::size_t bytes) const { return owned_.emplace_back(bytes).data(); }

    std::size_t bytes() const {
        std::size_t total = 0;
        for (const DeviceMemory& m : owned_) total += m.bytes();
        return total;
    }

private:
    const void* put(const void* host, std::size_t bytes) const {
        void* p = reserve(bytes);
        if (bytes > 0)
            check_cuda(cudaMemcpy(p, host, bytes, cudaMemcpyHostToDevice), "copying a layout to the device");
        return p;
    }

    mutable std::vector<DeviceMemory> owned_;
};

}  // namespace ctpbench
