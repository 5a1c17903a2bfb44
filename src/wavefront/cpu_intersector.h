// A strategy on CPU threads. Included where groups are instantiated, and nowhere else.
#pragma once

#include "kernels/registry.h"
#include "wavefront/counting_place.h"
#include "wavefront/intersector_groups.h"
#include "wavefront/placed_layouts.h"

namespace ctpbench {

template <class Strategy, class Methods>
class CpuIntersector final : public Intersector {
public:
    explicit CpuIntersector(const LayoutInput& input) : layout_(input) {}

    void intersect(CpuBackend& backend, const IntersectBuffers& io, bool carry_t) const override {
        Strategy::intersect(
            layout_.view(HostPlace{}), io, carry_t, [&](std::uint32_t count, const auto& kernel) {
                if (io.segment_counts == nullptr)
                    backend.for_each(count, kernel);
                else
                    backend.for_each_in_segments(io.segments, kSegment, io.segment_counts, kernel);
            });
    }
    bool excludes() const override { return Methods::excludes; }
    std::size_t bytes() const override { return layout_.bytes(); }
    void count(const LayoutInput& input, const CountingPlace& place) const override {
        layout_in<Strategy>(place, input, &layout_);
    }

private:
    typename Strategy::Layout layout_;
};

template <class Methods, class Types>
std::unique_ptr<Intersector> make_with_types(std::string_view strategy, const LayoutInput& input) {
    std::unique_ptr<Intersector> made;
    for_each_type(IntersectStrategies<Methods, Types>{}, [&](auto tag) {
        using Strategy = typename decltype(tag)::type;
        if (strategy == Strategy::name) made = std::make_unique<CpuIntersector<Strategy, Methods>>(input);
    });
    return made;
}

template <class Bundle>
std::unique_ptr<Intersector> make_with_bundle(std::string_view strategy, const LayoutInput& input) {
    std::unique_ptr<Intersector> made;
    visit_filtered<Primitives<Bundle>>(input.types, [&](auto list) {
        made = make_with_types<Bundle, typename decltype(list)::type>(strategy, input);
    });
    return made;
}

template <class List>
std::unique_ptr<Intersector> make_with_tests(std::string_view key, const LayoutInput& input) {
    std::unique_ptr<Intersector> made;
    for_each_type(List{}, [&](auto tag) {
        using Methods = typename decltype(tag)::type;
        if constexpr (!is_bundle<Methods>)
            if (key == tests_key<Methods>())
                visit_filtered<Primitives<Methods>>(input.types, [&](auto list) {
                    using Strategy = Ctp<Methods, typename decltype(list)::type>;
                    made = std::make_unique<CpuIntersector<Strategy, Methods>>(input);
                });
    });
    return made;
}

}  // namespace ctpbench
