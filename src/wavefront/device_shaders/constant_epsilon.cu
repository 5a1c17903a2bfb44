#include "wavefront/device_shade_strategy.cuh"

namespace ctpbench {

template std::unique_ptr<DeviceShader> make_on_device_with_offset<ConstantEpsilon>(const DevicePlace&,
                                                                                   std::string_view,
                                                                                   const MaterialInput&);

}  // namespace ctpbench
