#include "wavefront/batch.h"

#include <algorithm>
#include <numeric>

namespace ctpbench {

Batch record_batch(std::uint32_t bounce, RayColumns rays, const std::vector<std::uint32_t>& slots,
                   std::uint32_t limit, const std::uint32_t* excluded) {
    constexpr std::uint32_t run = 1024;
    Batch batch;
    batch.bounce = bounce;
    batch.active = static_cast<std::uint32_t>(slots.size());
    const std::uint32_t kept = limit == 0 ? batch.active : std::min(batch.active, limit);
    batch.slots.reserve(kept);
    const std::uint32_t runs = (kept + run - 1) / run;
    for (std::uint32_t r = 0; r < runs; ++r) {
        const std::uint32_t first = r * run, count = std::min(run, kept - first);
        // Even distances; the last run ends where the slots end.
        const std::uint64_t spare = batch.active - kept;
        const auto source = slots.begin() + static_cast<std::ptrdiff_t>(
                                                first + (runs > 1 ? spare * r / (runs - 1) : spare / 2));
        batch.slots.insert(batch.slots.end(), source, source + count);
    }
    batch.rays.resize(kept);
    batch.index.resize(kept);
    std::iota(batch.index.begin(), batch.index.end(), 0u);
    const RayColumns out = batch.rays.view();
    for (std::uint32_t i = 0; i < kept; ++i) out.store(i, rays.load(batch.slots[i]));
    if (excluded != nullptr)
        for (const std::uint32_t slot : batch.slots) batch.excluded.push_back(excluded[slot]);
    return batch;
}

IntersectBuffers batch_buffers(Batch& batch, HitStorage& hits, float extent) {
    hits.resize(batch.rays.size());
    IntersectBuffers io{batch.rays.view(), hits.view(), batch.index.data(),
                        static_cast<std::uint32_t>(batch.rays.size()), extent};
    if (!batch.excluded.empty()) io.excluded = batch.excluded.data();
    return io;
}

HitStorage record_hits(const Batch& batch, HitColumns hits) {
    HitStorage recorded;
    recorded.resize(batch.slots.size());
    const HitColumns out = recorded.view();
    for (std::uint32_t i = 0; i < batch.slots.size(); ++i) out.store(i, hits.load(batch.slots[i]));
    return recorded;
}

}  // namespace ctpbench
