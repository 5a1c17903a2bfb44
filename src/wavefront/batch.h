// The rays of one bounce, recorded from the pipeline so that every contender traces the very same ones.
#pragma once

#include <cstdint>
#include <vector>

#include "kernels/intersect.h"
#include "wavefront/columns.h"

namespace ctpbench {

struct Batch {
    std::uint32_t bounce = 0;
    std::uint32_t active = 0;  // paths that were active in the pipeline; the batch may hold a share of them
    RayStorage rays;
    std::vector<std::uint32_t> index;     // identity: the rays were gathered in the order of the slots
    std::vector<std::uint32_t> slots;     // where each ray was in the wavefront
    std::vector<std::uint32_t> excluded;  // the primitive that each ray leaves out; empty: none does
    std::uint64_t hit_hash = 0;           // of the hits that the pipeline found; 0: unknown
};

// Copies the rays in at most `limit` of the slots (0: all). A share is taken in runs of 1024 neighbours at
// even distances, so that rays keep the coherence that they have in the whole. `excluded`: as in
// BounceView.
Batch record_batch(std::uint32_t bounce, RayColumns rays, const std::vector<std::uint32_t>& slots,
                   std::uint32_t limit, const std::uint32_t* excluded = nullptr);

// What an intersector is given to trace a batch. `extent` is the scene's largest absolute coordinate.
IntersectBuffers batch_buffers(Batch& batch, HitStorage& hits, float extent);

// The hits of a batch's rays, from the same wavefront.
HitStorage record_hits(const Batch& batch, HitColumns hits);

}  // namespace ctpbench
