// The layouts of intersect strategies in a place's memory.
#pragma once

#include <string_view>
#include <type_traits>

#include "kernels/registry.h"
#include "kernels/yardstick/while_while.h"
#include "wavefront/placed_virtual_leaves.h"

namespace ctpbench {

template <class Strategy, class Methods, class Place>
auto layout_in(const Place& place, const LayoutInput& input) {
    if constexpr (std::is_same_v<Strategy, Oop<Methods>>)
        return virtual_leaves<Methods>(input, place, ObjectOrder::scene);
    else if constexpr (std::is_same_v<Strategy, OopArena<Methods>>)
        return virtual_leaves<Methods>(input, place, ObjectOrder::leaves);
    else
        return typename Strategy::Layout(input).view(place);
}

// Calls f(tag of the strategy, tag of the methods). The names must be registered, or be the yardstick's.
template <class F>
void visit_intersect_strategy(std::string_view strategy, std::string_view methods, F&& f) {
    if (strategy == WhileWhile::name) return f(TypeTag<WhileWhile>{}, TypeTag<Watertight>{});
    bool found = false;
    for_each_type(MethodBundles{}, [&](auto bundle) {
        using Methods = typename decltype(bundle)::type;
        if (methods != Methods::name) return;
        for_each_type(IntersectStrategies<Methods>{}, [&](auto tag) {
            if (strategy != decltype(tag)::type::name) return;
            found = true;
            f(tag, bundle);
        });
    });
    if (!found) trap();
}

}  // namespace ctpbench
