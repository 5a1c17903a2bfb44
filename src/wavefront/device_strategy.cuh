// A strategy on a device. Included where groups are instantiated, and nowhere else.
#pragma once

#include "wavefront/device_intersector_groups.cuh"
#include "wavefront/placed_layouts.h"

namespace ctpbench {

template <class Strategy, class Methods, class View>
class OnDevice final : public DeviceIntersector {
public:
    explicit OnDevice(const View& view) : view_(view) {}

    void intersect(cudaStream_t stream, const IntersectBuffers& io, DeviceCount count,
                   bool carry_t) const override {
        Strategy::intersect(view_, io, carry_t, [&](std::uint32_t, const auto& kernel) {
            launch_for_each(stream, count, kernel, "intersect");
        });
    }
    bool excludes() const override { return Methods::excludes; }

private:
    View view_;
};

template <class Strategy, class Methods>
std::unique_ptr<DeviceIntersector> made_for(const DevicePlace& place, const LayoutInput& input) {
    const auto view = layout_in<Strategy>(place, input);
    return std::make_unique<OnDevice<Strategy, Methods, std::remove_cv_t<decltype(view)>>>(view);
}

template <class Methods, class Types>
std::unique_ptr<DeviceIntersector> made_with_types(const DevicePlace& place, std::string_view strategy,
                                                   const LayoutInput& input) {
    std::unique_ptr<DeviceIntersector> made;
    for_each_type(IntersectStrategies<Methods, Types>{}, [&](auto tag) {
        using Strategy = typename decltype(tag)::type;
        if (strategy == Strategy::name) made = made_for<Strategy, Methods>(place, input);
    });
    return made;
}

template <class Bundle>
std::unique_ptr<DeviceIntersector> make_on_device_with_bundle(const DevicePlace& place,
                                                              std::string_view strategy,
                                                              const LayoutInput& input) {
    std::unique_ptr<DeviceIntersector> made;
    visit_filtered<Primitives<Bundle>>(input.types, [&](auto list) {
        made = made_with_types<Bundle, typename decltype(list)::type>(place, strategy, input);
    });
    return made;
}

template <class List>
std::unique_ptr<DeviceIntersector> make_on_device_with_tests(const DevicePlace& place, std::string_view key,
                                                             const LayoutInput& input) {
    std::unique_ptr<DeviceIntersector> made;
    for_each_type(List{}, [&](auto tag) {
        using Methods = typename decltype(tag)::type;
        if constexpr (!is_bundle<Methods>)
            if (key == tests_key<Methods>())
                visit_filtered<Primitives<Methods>>(input.types, [&](auto list) {
                    made = made_for<Ctp<Methods, typename decltype(list)::type>, Methods>(place, input);
                });
    });
    return made;
}

}  // namespace ctpbench
