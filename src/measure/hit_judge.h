// Verdicts on the hits of whole batches. The oracle traces each batch once, and equal hits need one verdict.
#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "oracle/check.h"
#include "wavefront/batch_tracer.h"
#include "wavefront/intersector.h"

namespace ctpbench {

class HitJudge {
public:
    // `oracle` may be null: then there is nobody to ask. At most about `sample` rays of a batch are judged.
    HitJudge(CpuBackend& backend, const GeometryView& geometry, const Intersector* oracle,
             std::uint32_t sample)
        : backend_(backend), judge_(geometry), oracle_(oracle), sample_(sample) {}

    bool can_judge() const { return oracle_ != nullptr; }

    // `number` names the batch, `hash` the hits.
    Verdict judge_hits(std::size_t number, Batch& batch, HitStorage& hits, std::uint64_t hash);
    // Of the batch that the tracer has traced last; its hits are fetched only if they are needed.
    Verdict judge_hits(std::size_t number, Batch& batch, BatchTracer& tracer, std::uint64_t hash);

private:
    CpuBackend& backend_;
    Judge judge_;
    const Intersector* oracle_;
    std::uint32_t sample_;
    std::map<std::size_t, HitStorage> oracle_hits_;
    std::map<std::pair<std::size_t, std::uint64_t>, Verdict> verdicts_;
};

}  // namespace ctpbench
