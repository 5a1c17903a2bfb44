#include "wavefront/intersector.h"

#include "kernels/registry.h"
#include "wavefront/intersector_groups.h"

namespace ctpbench {

std::vector<StrategyInfo> intersect_strategies() {
    std::vector<StrategyInfo> all;
    for_each_type(IntersectStrategies<Watertight>{}, [&](auto tag) {
        using Strategy = typename decltype(tag)::type;
        all.push_back({Strategy::name, Strategy::tree});
    });
    return all;
}

std::unique_ptr<Intersector> make_intersector(std::string_view strategy, std::string_view methods,
                                              const LayoutInput& input) {
    std::unique_ptr<Intersector> made;
    if (input.synthetic.any()) {
        if (methods == Watertight::name) made = make_synthetic(strategy, input);
        if (!made) trap();
        return made;
    }
    for_each_type(MethodBundles{}, [&](auto tag) {
        using Bundle = typename decltype(tag)::type;
        if (methods == Bundle::name) made = make_with_bundle<Bundle>(strategy, input);
    });
    if (made) return made;
    if (strategy != Ctp<Watertight>::name) trap();
    for_each_type(TriangleTests{}, [&](auto tag) {
        if (!made) made = make_with_tests<TestsWithTriangle<typename decltype(tag)::type>>(methods, input);
    });
    if (!made) made = make_with_tests<TestsWithSpheres>(methods, input);
    if (!made) made = make_with_tests<TypeList<ExcludingTests>>(methods, input);
    if (!made) trap();
    return made;
}

}  // namespace ctpbench
