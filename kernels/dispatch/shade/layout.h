// What shade strategies lay out their materials from, and what they are given to work on.
#pragma once

#include "../../array.h"
#include "../../path_queues.h"
#include "../../shade.h"
#include "../place.h"

namespace ctpbench {

// The materials of one scene, grouped by type: those of the type at position t of the list that a contender
// is compiled for have the numbers first[t] to first[t + 1] - 1. The caller's; it outlives the layout.
struct MaterialInput {
    const MaterialDescription* descriptions;
    const std::uint32_t* first;
    MaterialTypes types{};       // which list that is
    SyntheticTypes synthetic{};  // in its place, if there are any

    // Calls f(T::make(description)) for each material, by number.
    template <class Types, class F>
    void for_each(F&& f) const {
        for_each_type(Types{}, [&](auto tag) {
            using T = typename decltype(tag)::type;
            for (std::uint32_t i = begin<T, Types>(); i < end<T, Types>(); ++i) f(T::make(descriptions[i]));
        });
    }
    // The numbers of the materials of type T.
    template <class T, class Types>
    std::uint32_t begin() const {
        return first[index_of<T, Types>];
    }
    template <class T, class Types>
    std::uint32_t end() const {
        return first[index_of<T, Types> + 1];
    }
};

// In which order a strategy wants its paths. The bounce loop follows from it (paper, Fig. 2).
enum class PathOrder {
    as_traced,  // one kernel for all: intersect, shade, compact
    sorted,     // a kernel per type: intersect, sort, shade, compact; the order that sorting leaves stays
    restored,  // the same, but the order of the wavefront does not change: what is sorted are positions in it
    queued,    // a kernel per type: intersect fills queues, shade empties them and keeps the survivors
};

// The paths of one bounce.
struct ShadeWork {
    std::uint32_t count = 0;                       // as_traced: positions 0 to count - 1
    std::uint32_t key_offsets[kMaxShadeKeys + 1];  // sorted, restored: where each key's paths begin
    const std::uint32_t* positions = nullptr;      // restored: positions in the index, sorted by key
    PathQueues queues{};                           // queued
    std::uint32_t* survivors = nullptr;            // queued: slots of the paths that go on, by segment
    std::uint32_t* survivor_counts = nullptr;      // queued: how many, by segment
    std::uint32_t* dropped_counts = nullptr;       // queued: samples of value 0, by segment
    std::uint32_t segments = 0;                    // queued
};

// For strategies that look their material up in a table, whatever its type.
template <class Offset, class Table, class ForEach>
void shade_in_one_kernel(const Table& table, const ShadeBuffers& io, const ShadeWork& work,
                         ForEach&& for_each) {
    for_each(work.count, ShadeAnyKernel<Table, Offset>{table, io});
}

}  // namespace ctpbench
