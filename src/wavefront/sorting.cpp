#include "wavefront/sorting.h"

#include <numeric>
#include <utility>

#include "kernels/sort.h"

namespace ctpbench {
namespace {

// The kernel of two keys is the first.
template <std::uint32_t... numbers>
void scatter_few(CpuBackend& backend, const SortScatter& sort, std::uint32_t key_count,
                 std::integer_sequence<std::uint32_t, numbers...>) {
    ((numbers + 2 == key_count ? backend.for_each(sort.blocks, SortScatterKernel<numbers + 2>{sort}, 1)
                               : void()),
     ...);
}

}  // namespace

void Sorting::run(CpuBackend& backend, const std::uint8_t* keys, std::uint32_t key_count,
                  const std::uint32_t* index, std::uint32_t count, std::uint32_t* sorted,
                  std::uint32_t* offsets) {
    const std::uint32_t blocks = block_count(count);
    block_counts_.resize(std::size_t{blocks} * key_count);
    std::uint32_t* counts = block_counts_.data();
    backend.for_each(blocks, SortCountKernel{keys, count, blocks, counts, key_count}, 1);
    std::exclusive_scan(block_counts_.begin(), block_counts_.end(), block_counts_.begin(), 0u);
    for (std::uint32_t key = 0; key < key_count; ++key) offsets[key] = blocks > 0 ? counts[key * blocks] : 0;
    offsets[key_count] = count;
    const SortScatter sort{keys, index, count, blocks, counts, sorted};
    if (key_count <= kFewKeys)
        scatter_few(backend, sort, key_count, std::make_integer_sequence<std::uint32_t, kFewKeys - 1>{});
    else
        backend.for_each(blocks, SortScatterManyKernel{sort, key_count}, 1);
}

}  // namespace ctpbench
