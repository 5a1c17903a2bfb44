#include "wavefront/device_strategy.cuh"

namespace ctpbench {

template std::unique_ptr<DeviceIntersector> make_on_device_with_tests<TestsWithTriangle<MoellerTrumbore>>(
    const DevicePlace&, std::string_view, const LayoutInput&);

}  // namespace ctpbench
