// The layouts of `oop` and `oop_arena` on a device. Nobody allocates millions of objects one by one in
// kernels, so both have an array of objects per type; they differ in its order, which is what allocation
// order decides on a host: that of the scene, or that in which leaves first name them.
#pragma once

#include "kernels/dispatch/object_order.h"
#include "kernels/dispatch/oop.h"
#include "wavefront/placed_objects.h"

namespace ctpbench {

// elements[i] is the base-class pointer of what leaf entry i names.
template <class Base, class Object>
struct PointToObjects {
    const Base** elements;
    const PrimitiveRef* places;  // by leaf entry: type, and place among the objects of that type
    std::uint32_t type;
    const Object* objects;

    CTP_HD void operator()(std::uint32_t i) const {
        if (places[i].type == type) elements[i] = objects + places[i].index;
    }
};

template <class Methods, class Types, class Place>
VirtualLeaves<Methods> virtual_leaves(const LayoutInput& in, const Place& place, ObjectOrder order) {
    using Base = PrimitiveBase<Methods>;
    const ObjectPlaces places = place_objects<Types>(in.mixed, order);
    const auto entries = static_cast<std::uint32_t>(places.entries.size());
    const Base** elements = place.template reserve<const Base*>(entries);
    for_each_type(Types{}, [&](auto tag) {
        using T = typename decltype(tag)::type;
        using Object = PrimitiveObject<Methods, T>;
        constexpr auto type = static_cast<std::uint32_t>(index_of<T, Types>);
        Array<T> values;
        values.reserve(places.primitives[type].size());
        for (const std::uint32_t i : places.primitives[type]) values.push_back(T::make(in.geometry, i));
        const Object* objects = objects_in<Object>(place, values);
        const auto lent = place.lend(places.entries.data(), entries);
        place.launch(entries, PointToObjects<Base, Object>{elements, lent.data(), type, objects},
                     "pointing leaves to objects");
    });
    return {place(in.mixed.nodes, in.mixed.node_count), elements};
}

}  // namespace ctpbench
