// In which order the objects of a class hierarchy are made, and which object each leaf entry points to.
#pragma once

#include <limits>
#include <vector>

#include "layout.h"

namespace ctpbench {

enum class ObjectOrder {
    scene,   // that of the scene: what allocating one by one while it is read leaves
    leaves,  // that in which leaves first name them
};

// Objects of the primitives that leaves name, one each, however many leaves do.
struct ObjectPlaces {
    std::vector<std::vector<std::uint32_t>> primitives;  // by position in Types: scene indices, in order
    std::vector<PrimitiveRef> entries;  // by leaf entry: position in Types, place among those
};

template <class Types>
ObjectPlaces place_objects(const TreeView& tree, ObjectOrder order) {
    constexpr auto nowhere = std::numeric_limits<std::uint32_t>::max();
    ObjectPlaces places{std::vector<std::vector<std::uint32_t>>(Types::size), {}};
    std::vector<std::vector<std::uint32_t>> place_of(Types::size);  // by scene index
    places.entries.reserve(tree.ref_count);
    for (std::size_t i = 0; i < tree.ref_count; ++i)
        visit_by_tag<Types>(tree.refs[i].type, [&](auto tag) {
            constexpr std::uint32_t type = index_of<typename decltype(tag)::type, Types>;
            const std::uint32_t index = tree.refs[i].index;
            std::vector<std::uint32_t>& known = place_of[type];
            if (index >= known.size()) known.resize(index + 1, nowhere);
            if (known[index] == nowhere) {
                known[index] = static_cast<std::uint32_t>(places.primitives[type].size());
                places.primitives[type].push_back(index);
            }
            places.entries.push_back({type, known[index]});
        });
    if (order == ObjectOrder::leaves) return places;
    for (std::uint32_t type = 0; type < Types::size; ++type) {
        places.primitives[type].clear();
        for (std::uint32_t index = 0; index < place_of[type].size(); ++index) {
            std::uint32_t& place = place_of[type][index];
            if (place == nowhere) continue;
            place = static_cast<std::uint32_t>(places.primitives[type].size());
            places.primitives[type].push_back(index);
        }
    }
    for (std::size_t i = 0; i < tree.ref_count; ++i)
        places.entries[i].index = place_of[places.entries[i].type][tree.refs[i].index];
    return places;
}

}  // namespace ctpbench
