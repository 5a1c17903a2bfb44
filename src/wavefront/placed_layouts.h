// The layouts of intersect strategies in a place's memory.
#pragma once

#include <string_view>
#include <type_traits>

#include "kernels/methods/exchanges.h"
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

// Calls f(tag of the strategy, tag of the methods) with what make_intersector() makes of these names, or with
// the yardstick.
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
    const auto try_tests = [&](auto tag) {
        using Methods = typename decltype(tag)::type;
        if constexpr (!is_bundle<Methods>) {
            if (found || methods != tests_key<Methods>() || strategy != Ctp<Methods>::name) return;
            found = true;
            f(TypeTag<Ctp<Methods>>{}, tag);
        }
    };
    for_each_type(TriangleTests{}, [&](auto tag) {
        for_each_type(TestsWithTriangle<typename decltype(tag)::type>{}, try_tests);
    });
    for_each_type(TestsWithSpheres{}, try_tests);
    for_each_type(TypeList<ExcludingTests>{}, try_tests);
    if (!found) trap();
}

}  // namespace ctpbench
