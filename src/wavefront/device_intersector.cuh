// One contender of the intersect stage on a device: a strategy with its layout there.
#pragma once

#include <memory>
#include <string_view>

#include "kernels/dispatch/layout.h"
#include "wavefront/device_place.cuh"

namespace ctpbench {

class DeviceIntersector {
public:
    virtual ~DeviceIntersector() = default;
    // As Intersector::intersect(), of `count` active rays; all pointers are the device's.
    virtual void intersect(cudaStream_t stream, const IntersectBuffers& io, DeviceCount count,
                           bool carry_t) const = 0;
    // Whether it heeds IntersectBuffers::excluded.
    virtual bool excludes() const = 0;
};

// As make_intersector(); or the yardstick, whatever the methods. The place must outlive it.
std::unique_ptr<DeviceIntersector> make_device_intersector(const DevicePlace& place,
                                                           std::string_view strategy,
                                                           std::string_view methods,
                                                           const LayoutInput& input);

}  // namespace ctpbench
