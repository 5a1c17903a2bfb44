// The rays of one bounce, recorded from the pipeline so that every contender traces the very same ones.
#pragma once

#include <cstdint>
#include <vector>

#include "wavefront/columns.h"

namespace ctpbench {

struct Batch {
    std::uint32_t bounce = 0;
    std::uint32_t active = 0;  // paths that were active in the pipeline; the batch may hold a share of them
    RayStorage rays;
    std::vector<std::uint32_t> index;  // identity: the rays were gathered in the order of the index buffer
};

// Copies at most `limit` rays (0: all). A share is taken in runs of 1024 neighbours in the index buffer at
// even distances, so that rays keep the coherence that they have in the whole.
Batch record_batch(std::uint32_t bounce, RayColumns rays, const std::uint32_t* index, std::uint32_t active,
                   std::uint32_t limit);

}  // namespace ctpbench
