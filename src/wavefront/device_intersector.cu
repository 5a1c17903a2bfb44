#include "wavefront/device_intersector.cuh"

#include "kernels/registry.h"
#include "kernels/yardstick/while_while.h"
#include "wavefront/device_intersector_groups.cuh"

namespace ctpbench {

std::unique_ptr<DeviceIntersector> make_device_intersector(const DevicePlace& place,
                                                           std::string_view strategy,
                                                           std::string_view methods,
                                                           const LayoutInput& input) {
    if (strategy == WhileWhile::name) return make_device_yardstick(place, input);
    std::unique_ptr<DeviceIntersector> made;
    if (input.synthetic.any()) trap();  // type_choice.h
    for_each_type(MethodBundles{}, [&](auto tag) {
        using Bundle = typename decltype(tag)::type;
        if (methods == Bundle::name) made = make_on_device_with_bundle<Bundle>(place, strategy, input);
    });
    if (made) return made;
    if (strategy != Ctp<Watertight>::name) trap();
    for_each_type(TriangleTests{}, [&](auto tag) {
        using List = TestsWithTriangle<typename decltype(tag)::type>;
        if (!made) made = make_on_device_with_tests<List>(place, methods, input);
    });
    if (!made) made = make_on_device_with_tests<TestsWithSpheres>(place, methods, input);
    if (!made) made = make_on_device_with_tests<TypeList<ExcludingTests>>(place, methods, input);
    if (!made) trap();
    return made;
}

}  // namespace ctpbench
