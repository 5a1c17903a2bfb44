// A device's memory as a place (counting_place.h): what is put there is copied once and freed with this.
#pragma once

#include <cstddef>
#include <vector>

#include "backends/cuda_launch.cuh"
#include "backends/device_memory.cuh"
#include "wavefront/counting_place.h"

namespace ctpbench {

class DevicePlace {
public:
    template <class E>
    using Element = Slot<E>;

    template <class T>
    struct Lent {
        DeviceMemory memory;
        const T* data() const { return static_cast<const T*>(memory.data()); }
    };

    template <class T>
    const T* operator()(const T* array, std::size_t n) const {
        if (n == 0) return nullptr;  // as of an empty tree
        T* p = reserve<T>(n);
        upload(p, array, n);
        return p;
    }
    template <class T>
    const Slot<T>* elements(const Array<T>& array) const {
        if constexpr (sizeof(Slot<T>) == sizeof(T)) {
            return reinterpret_cast<const Slot<T>*>((*this)(array.data(), array.size()));
        } else {
            Array<Slot<T>> padded(array.size());
            for (std::size_t i = 0; i < array.size(); ++i) padded[i].value = array[i];
            return (*this)(padded.data(), padded.size());
        }
    }
    template <class T>
    T* reserve(std::size_t n) const {
        owned_.emplace_back(n * sizeof(T));
        bytes_.keep(n * sizeof(T));
        return static_cast<T*>(owned_.back().data());
    }
    template <class T>
    Lent<T> lend(const T* array, std::size_t n) const {
        Lent<T> lent{DeviceMemory(n * sizeof(T))};
        bytes_.lend(n * sizeof(T));
        upload(static_cast<T*>(lent.memory.data()), array, n);
        return lent;
    }
    template <class Kernel>
    void launch(std::uint32_t n, const Kernel& kernel, const char* name) const {
        launch_for_each(nullptr, {n}, kernel, name);
        check_cuda(cudaDeviceSynchronize(), name);
    }

    std::size_t bytes() const { return bytes_.total(); }

private:
    template <class T>
    static void upload(T* to, const T* host, std::size_t n) {
        if (n > 0)
            check_cuda(cudaMemcpy(to, host, n * sizeof(T), cudaMemcpyHostToDevice), "copying to the device");
    }

    mutable std::vector<DeviceMemory> owned_;
    mutable PlaceBytes bytes_;
};

}  // namespace ctpbench
