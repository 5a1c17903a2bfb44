#include "wavefront/shader.h"

#include "kernels/registry.h"
#include "wavefront/shader_groups.h"

namespace ctpbench {

std::vector<std::string> shade_strategies() {
    std::vector<std::string> names;
    for_each_type(ShadeStrategies<Materials>{},
                  [&](auto tag) { names.push_back(decltype(tag)::type::name); });
    return names;
}

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
