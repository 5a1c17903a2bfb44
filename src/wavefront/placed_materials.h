// The materials of shade strategies in a place's memory.
#pragma once

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
template <class Types, class Place>
VirtualMaterials virtual_materials(const MaterialInput& in, const Place& place, bool apart) {
    const MaterialBase** pointers = place.template reserve<const MaterialBase*>(in.first[Types::size]);
    for_each_type(Types{}, [&](auto tag) {
        using T = typename decltype(tag)::type;
        using Object = MaterialObject<T>;
        const std::uint32_t end = in.end<T, Types>();
        for (std::uint32_t begin = in.begin<T, Types>(), next; begin < end; begin = next) {
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

template <class Strategy>
struct PlacedMaterials {
    template <class Place>
    static auto make(const Place& place, const MaterialInput& in) {
        return typename Strategy::Layout(in).view(place);
    }
};
template <class Types>
struct PlacedMaterials<ShadeOop<Types>> {
    template <class Place>
    static auto make(const Place& place, const MaterialInput& in) {
        return virtual_materials<Types>(in, place, true);
    }
};
template <class Types>
struct PlacedMaterials<ShadeOopArena<Types>> {
    template <class Place>
    static auto make(const Place& place, const MaterialInput& in) {
        return virtual_materials<Types>(in, place, false);
    }
};

template <class Strategy, class Place>
auto materials_in(const Place& place, const MaterialInput& in) {
    return PlacedMaterials<Strategy>::make(place, in);
}

}  // namespace ctpbench
