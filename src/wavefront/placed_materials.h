// The materials of shade strategies in a place's memory.
#pragma once

#include <type_traits>

#include "kernels/registry.h"
#include "wavefront/placed_objects.h"

namespace ctpbench {

// Base-class pointers to objects that lie side by side.
template <class Object>
struct PointToMaterials {
    const MaterialBase** pointers;
    const Object* objects;

    CTP_HD void operator()(std::uint32_t i) const { pointers[i] = objects + i; }
};

// As on the host, `oop` has its objects apart and `oop_arena` has those of one type together.
template <class Place>
VirtualMaterials virtual_materials(const MaterialInput& in, const Place& place, bool apart) {
    const MaterialBase** pointers = place.template reserve<const MaterialBase*>(in.count());
    for_each_type(Materials{}, [&](auto tag) {
        using T = typename decltype(tag)::type;
        using Object = MaterialObject<T>;
        const std::uint32_t first = in.first[material_type<T>], end = in.first[material_type<T> + 1];
        for (std::uint32_t begin = first, next; begin < end; begin = next) {
            next = apart ? begin + 1 : end;
            Array<T> values;
            for (std::uint32_t i = begin; i < next; ++i) values.push_back(T::make(in.descriptions[i]));
            const Object* objects = objects_in<Object>(place, values);
            place.launch(next - begin, PointToMaterials<Object>{pointers + begin, objects},
                         "pointing to materials");
        }
    });
    return {pointers};
}

template <class Strategy, class Place>
auto materials_in(const Place& place, const MaterialInput& materials) {
    if constexpr (std::is_same_v<Strategy, ShadeOop> || std::is_same_v<Strategy, ShadeOopArena>)
        return virtual_materials(materials, place, std::is_same_v<Strategy, ShadeOop>);
    else
        return typename Strategy::Layout(materials).view(place);
}

}  // namespace ctpbench
