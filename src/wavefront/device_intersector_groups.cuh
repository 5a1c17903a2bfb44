// The explicit instantiations of intersectors on a device, in the groups of intersector_groups.h
// (device_intersectors/).
#pragma once

#include "kernels/methods/exchanges.h"
#include "wavefront/device_intersector.cuh"

namespace ctpbench {

// As make_with_bundle() and make_with_tests(). The place must outlive what is made.
template <class Bundle>
std::unique_ptr<DeviceIntersector> make_on_device_with_bundle(const DevicePlace& place,
                                                              std::string_view strategy,
                                                              const LayoutInput& input);
template <class List>
std::unique_ptr<DeviceIntersector> make_on_device_with_tests(const DevicePlace& place, std::string_view key,
                                                             const LayoutInput& input);

// The yardstick, which has methods of its own.
std::unique_ptr<DeviceIntersector> make_device_yardstick(const DevicePlace& place, const LayoutInput& input);

}  // namespace ctpbench
