// Verdicts on many rays, judged by all threads.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "backends/cpu.h"
#include "oracle/check.h"

namespace ctpbench {

// The sum of each(i, verdict) over i in 0..n-1.
template <class Each>
Verdict judged(CpuBackend& backend, std::uint32_t n, const Each& each) {
    constexpr std::uint32_t chunk = 1024;  // rays of one verdict
    const std::uint32_t chunks = (n + chunk - 1) / chunk;
    std::vector<Verdict> parts(chunks);
    backend.for_each(
        chunks,
        [&](std::uint32_t c) {
            for (std::uint32_t i = c * chunk; i < std::min(n, (c + 1) * chunk); ++i) each(i, parts[c]);
        },
        1);
    return std::accumulate(parts.begin(), parts.end(), Verdict{},
                           [](Verdict sum, const Verdict& part) { return sum += part; });
}

}  // namespace ctpbench
