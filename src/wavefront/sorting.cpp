#include "wavefront/sorting.h"

#include <numeric>

#include "kernels/sort.h"

namespace ctpbench {

void Sorting::run(CpuBackend& backend, const std::uint8_t* keys, const std::uint32_t* index,
                  std::uint32_t count, std::uint32_t* sorted, std::uint32_t (&offsets)[kShadeKeys + 1]) {
    const std::uint32_t blocks = block_count(count);
    block_counts_.resize(std::size_t{blocks} * kShadeKeys);
    std::uint32_t* counts = block_counts_.data();
    backend.for_each(blocks, SortCountKernel{keys, count, blocks, counts}, 1);
    std::exclusive_scan(block_counts_.begin(), block_counts_.end(), block_counts_.begin(), 0u);
    for (std::uint32_t key = 0; key < kShadeKeys; ++key) offsets[key] = blocks > 0 ? counts[key * blocks] : 0;
    offsets[kShadeKeys] = count;
    backend.for_each(blocks, SortScatterKernel{keys, index, count, blocks, counts, sorted}, 1);
}

}  // namespace ctpbench
