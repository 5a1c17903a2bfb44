// Objects with virtual functions, constructed on the device by placement new: a virtual table belongs to the
// side on which an object was made.
#pragma once

#include <new>

#include "backends/cuda_launch.cuh"
#include "wavefront/device_place.cuh"

namespace ctpbench {

template <class Object, class Value>
struct ConstructObjects {
    Object* objects;
    const Value* values;

    __device__ void operator()(std::uint32_t i) const { new (objects + i) Object(values[i]); }
};

template <class Object, class Value>
Object* construct_objects(const DevicePlace& place, const Array<Value>& values) {
    const DeviceArray<Value> on_device(values.data(), values.size());
    auto* objects = static_cast<Object*>(place.reserve(values.size() * sizeof(Object)));
    launch_for_each(nullptr, {static_cast<std::uint32_t>(values.size())},
                    ConstructObjects<Object, Value>{objects, on_device.data()}, "constructing objects");
    check_cuda(cudaDeviceSynchronize(), "constructing objects on the device");
    return objects;
}

}  // namespace ctpbench
