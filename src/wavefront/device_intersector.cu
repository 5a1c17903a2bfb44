// The explicit instantiations of every intersect strategy with every bundle of methods, on a device.
#include "wavefront/device_intersector.cuh"

#include "wavefront/placed_layouts.h"

namespace ctpbench {
namespace {

template <class Strategy, class View>
class OnDevice final : public DeviceIntersector {
public:
    explicit OnDevice(const View& view) : view_(view) {}

    void intersect(cudaStream_t stream, const IntersectBuffers& io, DeviceCount count,
                   bool carry_t) const override {
        Strategy::intersect(view_, io, carry_t, [&](std::uint32_t, const auto& kernel) {
            launch_for_each(stream, count, kernel, "intersect");
        });
    }

private:
    View view_;
};

}  // namespace

std::unique_ptr<DeviceIntersector> make_device_intersector(const DevicePlace& place,
                                                           std::string_view strategy,
                                                           std::string_view methods,
                                                           const LayoutInput& input) {
    std::unique_ptr<DeviceIntersector> made;
    visit_intersect_strategy(strategy, methods, [&](auto tag, auto bundle) {
        using Strategy = typename decltype(tag)::type;
        using Methods = typename decltype(bundle)::type;
        using View = decltype(layout_in<Strategy, Methods>(place, input));
        made = std::make_unique<OnDevice<Strategy, View>>(layout_in<Strategy, Methods>(place, input));
    });
    return made;
}

}  // namespace ctpbench
