#include "kernels/synthetic/matte.h"
#include "wavefront/cpu_shader.h"

namespace ctpbench {

std::unique_ptr<Shader> make_synthetic(std::string_view strategy, const MaterialTable& materials) {
    std::unique_ptr<Shader> made;
    visit_synthetic<SyntheticMatte>(materials.input().synthetic, [&](auto list) {
        made = make_with_types<WaechterBinder, typename decltype(list)::type>(strategy, materials);
    });
    return made;
}

}  // namespace ctpbench
