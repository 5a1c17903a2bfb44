#include "measure/hit_judge.h"

namespace ctpbench {

IntersectBuffers batch_buffers(Batch& batch, HitStorage& hits, const GeometryView& geometry) {
    hits.resize(batch.rays.size());
    return {batch.rays.view(), hits.view(), batch.index.data(), static_cast<std::uint32_t>(batch.rays.size()),
            geometry.extent};
}

Verdict HitJudge::judge_hits(std::size_t number, Batch& batch, HitStorage& hits, std::uint64_t hash) {
    const auto known = verdicts_.find({number, hash});
    if (known != verdicts_.end()) return known->second;
    const auto [expected, added] = oracle_hits_.try_emplace(number);
    if (added) oracle_->intersect(backend_, batch_buffers(batch, expected->second, geometry_), true);
    const Verdict verdict = judge(batch, hits.view(), expected->second.view(), geometry_, sample_);
    return verdicts_.emplace(std::pair{number, hash}, verdict).first->second;
}

}  // namespace ctpbench
