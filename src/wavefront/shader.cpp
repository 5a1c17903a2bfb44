#include "wavefront/shader.h"

#include "base/type_names.h"
#include "kernels/registry.h"
#include "wavefront/shader_groups.h"

namespace ctpbench {

std::vector<std::string> shade_strategies() { return names_of<ShadeStrategies<Materials>>(); }

std::unique_ptr<Shader> make_shader(std::string_view strategy, const MaterialTable& materials,
                                    std::string_view offset) {
    std::unique_ptr<Shader> made;
    if (materials.input().synthetic.any()) {
        if (offset == Watertight::Offset::name) made = make_synthetic(strategy, materials);
        if (!made) trap();
        return made;
    }
    for_each_type(Offsets{}, [&](auto tag) {
        using Offset = typename decltype(tag)::type;
        if (offset == Offset::name) made = make_with_offset<Offset>(strategy, materials);
    });
    if (!made) trap();
    return made;
}

}  // namespace ctpbench
