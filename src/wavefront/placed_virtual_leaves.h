// The layouts of `oop` and `oop_arena` on a device. Nobody allocates millions of objects one by one in
// kernels, so both have an array of objects per type; they differ in its order, which is what allocation
// order decides on a host: that of the scene, or that in which leaves first name them.
#pragma once

#include <limits>
#include <vector>

#include "kernels/dispatch/oop.h"
#include "wavefront/placed_objects.h"

namespace ctpbench {

enum class ObjectOrder { scene, leaves };

// elements[i] is the base-class pointer of what leaf entry i names.
template <class Base, class Object>
struct PointToObjects {
    const Base** elements;
    const PrimitiveRef* places;  // by leaf entry: type, and number among the objects of that type
    std::uint32_t type;
    const Object* objects;

    CTP_HD void operator()(std::uint32_t i) const {
        if (places[i].type == type) elements[i] = objects + places[i].index;
    }
};

template <class Methods, class Place>
VirtualLeaves<Methods> virtual_leaves(const LayoutInput& in, const Place& place, ObjectOrder order) {
    using Base = PrimitiveBase<Methods>;
    constexpr auto unplaced = std::numeric_limits<std::uint32_t>::max();
    const auto entries = static_cast<std::uint32_t>(in.mixed.ref_count);
    std::vector<PrimitiveRef> places(in.mixed.refs, in.mixed.refs + entries);
    const Base** elements = place.template reserve<const Base*>(entries);
    for_each_type(Primitives<Methods>{}, [&](auto tag) {
        using T = typename decltype(tag)::type;
        using Object = PrimitiveObject<Methods, T>;
        constexpr auto type = static_cast<std::uint32_t>(index_of<T, Primitives<Methods>>);
        Array<T> values;
        values.reserve(T::count(in.geometry));
        if (order == ObjectOrder::scene) {
            for (std::uint32_t i = 0; i < T::count(in.geometry); ++i)
                values.push_back(T::make(in.geometry, i));
        } else {
            std::vector<std::uint32_t> at(T::count(in.geometry), unplaced);
            for (PrimitiveRef& p : places) {
                if (p.type != type) continue;
                if (at[p.index] == unplaced) {
                    at[p.index] = static_cast<std::uint32_t>(values.size());
                    values.push_back(T::make(in.geometry, p.index));
                }
                p.index = at[p.index];
            }
        }
        const Object* objects = objects_in<Object>(place, values);
        const auto lent = place.lend(places.data(), entries);
        place.launch(entries, PointToObjects<Base, Object>{elements, lent.data(), type, objects},
                     "pointing leaves to objects");
    });
    return {place(in.mixed.nodes, in.mixed.node_count), elements};
}

}  // namespace ctpbench
