#include "wavefront/compaction.h"

#include <numeric>

#include "kernels/compact.h"

namespace ctpbench {

std::uint32_t Compaction::run(CpuBackend& backend, const std::uint8_t* fates, const std::uint32_t* index,
                              std::uint32_t count, std::uint32_t* compacted) {
    const std::uint32_t blocks = block_count(count);
    block_counts_.resize(blocks + 1);
    backend.for_each(blocks, CompactCountKernel{fates, count, block_counts_.data()}, 1);
    block_counts_[blocks] = 0;
    // One entry per block: too few for a parallel scan to pay.
    std::exclusive_scan(block_counts_.begin(), block_counts_.end(), block_counts_.begin(), 0u);
    backend.for_each(blocks, CompactScatterKernel{fates, index, count, block_counts_.data(), compacted}, 1);
    return block_counts_[blocks];
}

}  // namespace ctpbench
