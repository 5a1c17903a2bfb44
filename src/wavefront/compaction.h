// Stable parallel compaction of the index buffer.
#pragma once

#include <vector>

#include "backends/cpu.h"
#include "kernels/wavefront.h"

namespace ctpbench {

class Compaction {
public:
    // Writes the indices whose hit is one to `compacted`, in order; returns how many there are.
    std::uint32_t run(CpuBackend& backend, HitColumns hits, const std::uint32_t* index, std::uint32_t count,
                      std::uint32_t* compacted);

private:
    std::vector<std::uint32_t> block_counts_;
};

}  // namespace ctpbench
