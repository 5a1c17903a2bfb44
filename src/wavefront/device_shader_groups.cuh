// The explicit instantiations of shaders on a device, one per offset (device_shaders/).
#pragma once

#include "kernels/methods/lists.h"
#include "wavefront/device_shader.cuh"

namespace ctpbench {

// As make_with_offset(). The place must outlive what is made.
template <class Offset>
std::unique_ptr<DeviceShader> make_on_device_with_offset(const DevicePlace& place, std::string_view strategy,
                                                         const MaterialInput& materials);

std::unique_ptr<DeviceShader> make_synthetic_on_device(const DevicePlace& place, std::string_view strategy,
                                                       const MaterialInput& materials);

}  // namespace ctpbench
