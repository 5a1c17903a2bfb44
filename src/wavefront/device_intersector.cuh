// One contender of the intersect stage on a device: a strategy with its layout there.
#pragma once

#include <memory>
#include <string_view>

#include "backends/cuda_launch.cuh"
#include "kernels/dispatch/layout.h"

namespace ctpbench {

class DeviceIntersector {
public:
    virtual ~DeviceIntersector() = default;
    // As Intersector::intersect(), of `count` active rays; all pointers are the device's.
    virtual void intersect(cudaStream_t stream, const IntersectBuffers& io, DeviceCount count,
                           bool carry_t) const = 0;
    // Whether it heeds IntersectBuffers::excluded.
    virtual bool excludes() const = 0;
    virtual std::size_t bytes() const = 0;
};

// As make_intersector(); or the yardstick, whatever the methods.
std::unique_ptr<DeviceIntersector> make_device_intersector(std::string_view strategy,
                                                           std::string_view methods,
                                                           const LayoutInput& input);

}  // namespace ctpbench
