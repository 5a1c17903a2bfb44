// The layouts of intersect strategies in a place's memory.
#pragma once

#include "kernels/registry.h"
#include "wavefront/placed_virtual_leaves.h"

namespace ctpbench {

// Of strategies whose layout there is not the host's.
template <class Strategy>
struct PlacedLayout {
    static constexpr bool differs = false;
};
template <class Methods, class Types>
struct PlacedLayout<Oop<Methods, Types>> {
    static constexpr bool differs = true;
    template <class Place>
    static auto make(const Place& place, const LayoutInput& input) {
        return virtual_leaves<Methods, Types>(input, place, ObjectOrder::scene);
    }
};
template <class Methods, class Types>
struct PlacedLayout<OopArena<Methods, Types>> {
    static constexpr bool differs = true;
    template <class Place>
    static auto make(const Place& place, const LayoutInput& input) {
        return virtual_leaves<Methods, Types>(input, place, ObjectOrder::leaves);
    }
};

// `layout`: the strategy's on the host; null if it has not been made yet.
template <class Strategy, class Place>
auto layout_in(const Place& place, const LayoutInput& input,
               const typename Strategy::Layout* layout = nullptr) {
    if constexpr (PlacedLayout<Strategy>::differs)
        return PlacedLayout<Strategy>::make(place, input);
    else
        return layout != nullptr ? layout->view(place) : typename Strategy::Layout(input).view(place);
}

}  // namespace ctpbench
