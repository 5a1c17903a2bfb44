#include "kernels/synthetic/triangle.h"
#include "wavefront/cpu_intersector.h"

namespace ctpbench {

std::unique_ptr<Intersector> make_synthetic(std::string_view strategy, const LayoutInput& input) {
    std::unique_ptr<Intersector> made;
    visit_synthetic<SyntheticTriangle>(input.synthetic, [&](auto list) {
        made = make_with_types<Watertight, typename decltype(list)::type>(strategy, input);
    });
    return made;
}

}  // namespace ctpbench
