// Stable parallel compaction of the index buffer.
#pragma once

#include <cstdint>
#include <vector>

#include "backends/cpu.h"

namespace ctpbench {

class Compaction {
public:
    // Writes the entries whose fate is to go on to `compacted`, in order; returns how many there are.
    // fates[i] is that of index[i].
    std::uint32_t run(CpuBackend& backend, const std::uint8_t* fates, const std::uint32_t* index,
                      std::uint32_t count, std::uint32_t* compacted);

private:
    std::vector<std::uint32_t> block_counts_;
};

}  // namespace ctpbench
