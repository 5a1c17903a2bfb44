#include "wavefront/batch.h"

#include <algorithm>
#include <numeric>

namespace ctpbench {

Batch record_batch(std::uint32_t bounce, RayColumns rays, const std::uint32_t* index, std::uint32_t active,
                   std::uint32_t limit) {
    constexpr std::uint32_t run = 1024;
    Batch batch;
    batch.bounce = bounce;
    batch.active = active;
    const std::uint32_t kept = limit == 0 ? active : std::min(active, limit);
    batch.rays.resize(kept);
    batch.index.resize(kept);
    std::iota(batch.index.begin(), batch.index.end(), 0u);
    const RayColumns out = batch.rays.view();
    const std::uint32_t runs = (kept + run - 1) / run;
    for (std::uint32_t r = 0; r < runs; ++r) {
        const std::uint32_t first = r * run, count = std::min(run, kept - first);
        // Even distances; the last run ends where the buffer ends.
        const std::uint64_t spare = active - kept;
        const auto source =
            static_cast<std::uint32_t>(first + (runs > 1 ? spare * r / (runs - 1) : spare / 2));
        for (std::uint32_t i = 0; i < count; ++i) out.store(first + i, rays.load(index[source + i]));
    }
    return batch;
}

}  // namespace ctpbench
