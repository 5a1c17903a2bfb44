// The explicit instantiations of every intersect strategy with every bundle of methods, on a device.
#include "wavefront/device_intersector.cuh"

#include "kernels/registry.h"
#include "kernels/yardstick/while_while.h"
#include "wavefront/device_objects.cuh"
#include "wavefront/device_virtual_leaves.cuh"

namespace ctpbench {
namespace {

// What strategies that store values lay out is copied to the device.
template <class Strategy>
auto device_view(const LayoutInput& input, const DevicePlace& place) {
    return typename Strategy::Layout(input).view(place);
}

template <class Strategy, class Methods>
auto view_of(const LayoutInput& input, const DevicePlace& place) {
    if constexpr (std::is_same_v<Strategy, Oop<Methods>>)
        return virtual_leaves<Methods>(input, place, ObjectOrder::scene);
    else if constexpr (std::is_same_v<Strategy, OopArena<Methods>>)
        return virtual_leaves<Methods>(input, place, ObjectOrder::leaves);
    else
        return device_view<Strategy>(input, place);
}

template <class Strategy, class View>
class OnDevice final : public DeviceIntersector {
public:
    OnDevice(DevicePlace place, const View& view) : place_(std::move(place)), view_(view) {}

    void intersect(cudaStream_t stream, const IntersectBuffers& io, DeviceCount count,
                   bool carry_t) const override {
        Strategy::intersect(view_, io, carry_t, [&](std::uint32_t, const auto& kernel) {
            launch_for_each(stream, count, kernel, "intersect");
        });
    }
    std::size_t bytes() const override { return place_.bytes(); }

private:
    DevicePlace place_;
    View view_;
};

template <class Strategy, class Methods>
std::unique_ptr<DeviceIntersector> made_for(const LayoutInput& input) {
    DevicePlace place;
    const auto view = view_of<Strategy, Methods>(input, place);
    return std::make_unique<OnDevice<Strategy, std::remove_cv_t<decltype(view)>>>(std::move(place), view);
}

}  // namespace

std::unique_ptr<DeviceIntersector> make_device_intersector(std::string_view strategy,
                                                           std::string_view methods,
                                                           const LayoutInput& input) {
    if (strategy == WhileWhile::name) return made_for<WhileWhile, Watertight>(input);
    std::unique_ptr<DeviceIntersector> made;
    for_each_type(MethodBundles{}, [&](auto bundle) {
        using Methods = typename decltype(bundle)::type;
        if (methods != Methods::name) return;
        for_each_type(IntersectStrategies<Methods>{}, [&](auto tag) {
            using Strategy = typename decltype(tag)::type;
            if (strategy == Strategy::name) made = made_for<Strategy, Methods>(input);
        });
    });
    if (!made) trap();
    return made;
}

}  // namespace ctpbench
