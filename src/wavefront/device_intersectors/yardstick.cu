#include "kernels/yardstick/while_while.h"
#include "wavefront/device_strategy.cuh"

namespace ctpbench {

std::unique_ptr<DeviceIntersector> make_device_yardstick(const DevicePlace& place, const LayoutInput& input) {
    return made_for<WhileWhile, Watertight>(place, input);
}

}  // namespace ctpbench
