// A strategy on a device. Included where groups are instantiated, and nowhere else.
#pragma once

#include "kernels/registry.h"
#include "wavefront/device_intersector_groups.cuh"
#include "wavefront/device_objects.cuh"
#include "wavefront/device_virtual_leaves.cuh"

namespace ctpbench {

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

template <class Strategy, class Methods, class View>
class OnDevice final : public DeviceIntersector {
public:
    OnDevice(DevicePlace place, const View& view) : place_(std::move(place)), view_(view) {}

    void intersect(cudaStream_t stream, const IntersectBuffers& io, DeviceCount count,
                   bool carry_t) const override {
        Strategy::intersect(view_, io, carry_t, [&](std::uint32_t, const auto& kernel) {
            launch_for_each(stream, count, kernel, "intersect");
        });
    }
    bool excludes() const override { return Methods::excludes; }
    std::size_t bytes() const override { return place_.bytes(); }

private:
    DevicePlace place_;
    View view_;
};

template <class Strategy, class Methods>
std::unique_ptr<DeviceIntersector> made_for(const LayoutInput& input) {
    DevicePlace place;
    const auto view = view_of<Strategy, Methods>(input, place);
    return std::make_unique<OnDevice<Strategy, Methods, std::remove_cv_t<decltype(view)>>>(std::move(place),
                                                                                           view);
}

template <class Bundle>
std::unique_ptr<DeviceIntersector> make_on_device_with_bundle(std::string_view strategy,
                                                              const LayoutInput& input) {
    std::unique_ptr<DeviceIntersector> made;
    for_each_type(IntersectStrategies<Bundle>{}, [&](auto tag) {
        using Strategy = typename decltype(tag)::type;
        if (strategy == Strategy::name) made = made_for<Strategy, Bundle>(input);
    });
    return made;
}

template <class List>
std::unique_ptr<DeviceIntersector> make_on_device_with_tests(std::string_view key, const LayoutInput& input) {
    std::unique_ptr<DeviceIntersector> made;
    for_each_type(List{}, [&](auto tag) {
        using Methods = typename decltype(tag)::type;
        if constexpr (!is_bundle<Methods>)
            if (key == tests_key<Methods>()) made = made_for<Ctp<Methods>, Methods>(input);
    });
    return made;
}

}  // namespace ctpbench
