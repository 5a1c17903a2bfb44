#include "measure/hit_comparison.h"

#include "measure/judged.h"

namespace ctpbench {

Verdict HitComparison::compare(std::size_t number, Batch& batch, BatchTracer& tracer, std::uint64_t hash) {
    const auto [verdict, added] = verdicts_.try_emplace({number, hash});
    if (!added) return verdict->second;
    const HitColumns hits = tracer.hits().view(), found = found_[number].view();
    const RayColumns rays = batch.rays.view();
    verdict->second = judged(
        backend_, static_cast<std::uint32_t>(batch.rays.size()),
        [&](std::uint32_t i, Verdict& part) { judge_.ray(rays.load(i), hits.load(i), found.load(i), part); });
    return verdict->second;
}

}  // namespace ctpbench
