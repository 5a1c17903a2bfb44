// Stable parallel counting sort of the index buffer by shade key.
#pragma once

#include <cstdint>
#include <vector>

#include "backends/cpu.h"
#include "kernels/material_words.h"

namespace ctpbench {

class Sorting {
public:
    // keys[i], below key_count, is that of index[i]. Sets offsets[k] to where key k's entries begin in
    // `sorted`, and offsets[key_count] to the count. Of keys there are two at least and kMaxShadeKeys at
    // most.
    void run(CpuBackend& backend, const std::uint8_t* keys, std::uint32_t key_count,
             const std::uint32_t* index, std::uint32_t count, std::uint32_t* sorted, std::uint32_t* offsets);

private:
    std::vector<std::uint32_t> block_counts_;
};

}  // namespace ctpbench
