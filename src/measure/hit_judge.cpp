#include "measure/hit_judge.h"

namespace ctpbench {

Verdict HitJudge::judge_hits(std::size_t number, Batch& batch, HitStorage& hits, std::uint64_t hash) {
    const auto known = verdicts_.find({number, hash});
    if (known != verdicts_.end()) return known->second;
    const auto [expected, added] = oracle_hits_.try_emplace(number);
    if (added)
        oracle_->intersect(backend_, batch_buffers(batch, expected->second, judge_.geometry().extent), true);
    const Verdict verdict = judge_.batch(batch, hits.view(), expected->second.view(), sample_);
    return verdicts_.emplace(std::pair{number, hash}, verdict).first->second;
}

Verdict HitJudge::judge_hits(std::size_t number, Batch& batch, BatchTracer& tracer, std::uint64_t hash) {
    const auto known = verdicts_.find({number, hash});
    return known != verdicts_.end() ? known->second : judge_hits(number, batch, tracer.hits(), hash);
}

}  // namespace ctpbench
