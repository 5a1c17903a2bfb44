// Recorded batches in a place's memory, each with room for the hits that are found first.
#pragma once

#include <algorithm>
#include <vector>

#include "wavefront/batch.h"
#include "wavefront/placed_columns.h"

namespace ctpbench {

struct PlacedBatch {
    RayColumns rays;
    const std::uint32_t* index;
    const std::uint32_t* excluded;  // null: no ray leaves out anything
    HitColumns first_hits;
    std::uint64_t first_hash = 0;  // 0: there are none yet
};

struct PlacedBatches {
    std::vector<PlacedBatch> each;
    HitColumns hits;        // where contenders leave theirs; every batch fits
    std::uint32_t* differ;  // for comparisons
};

// Rays are not copied.
template <class Place>
PlacedBatches batches_in(const Place& place, const std::vector<Batch>& batches) {
    PlacedBatches placed{};
    std::size_t longest = 0;
    for (const Batch& batch : batches) {
        const std::size_t n = batch.rays.size();
        longest = std::max(longest, n);
        const std::uint32_t* excluded = batch.excluded.empty() ? nullptr : place(batch.excluded.data(), n);
        placed.each.push_back({rays_in(place, n), place(batch.index.data(), n), excluded, hits_in(place, n)});
    }
    placed.hits = hits_in(place, longest);
    placed.differ = place.template reserve<std::uint32_t>(1);
    return placed;
}

}  // namespace ctpbench
