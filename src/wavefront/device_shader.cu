#include "wavefront/device_shader.cuh"

#include "kernels/methods/bundles.h"
#include "wavefront/device_shader_groups.cuh"

namespace ctpbench {

std::unique_ptr<DeviceShader> make_device_shader(const DevicePlace& place, std::string_view strategy,
                                                 const MaterialInput& materials, std::string_view offset) {
    std::unique_ptr<DeviceShader> made;
    if (materials.synthetic.any()) {
        if (offset == Watertight::Offset::name) made = make_synthetic_on_device(place, strategy, materials);
        if (!made) trap();
        return made;
    }
    for_each_type(Offsets{}, [&](auto tag) {
        using Offset = typename decltype(tag)::type;
        if (offset == Offset::name) made = make_on_device_with_offset<Offset>(place, strategy, materials);
    });
    if (!made) trap();
    return made;
}

}  // namespace ctpbench
