#include "kernels/synthetic/matte.h"
#include "wavefront/device_shade_strategy.cuh"

namespace ctpbench {

std::unique_ptr<DeviceShader> make_synthetic_on_device(const DevicePlace& place, std::string_view strategy,
                                                       const MaterialInput& materials) {
    std::unique_ptr<DeviceShader> made;
    visit_synthetic<SyntheticMatte, true>(materials.synthetic, [&](auto list) {
        made = shader_with_types<WaechterBinder, typename decltype(list)::type>(place, strategy, materials);
    });
    return made;
}

}  // namespace ctpbench
