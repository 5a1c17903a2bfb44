// What contenders hit beside what the recorded frame hit, on the very same rays. All rays are compared, since
// differences are rare; equal hits are compared once.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "oracle/check.h"
#include "wavefront/batch_tracer.h"

namespace ctpbench {

class CpuBackend;

class HitComparison {
public:
    // `found`: by batch, what its rays hit in the frame that they were recorded from. What is given must
    // outlive it.
    HitComparison(CpuBackend& backend, const GeometryView& geometry, std::vector<HitStorage>& found)
        : backend_(backend), judge_(geometry), found_(found) {}

    // Of the batch of that number, which the tracer has traced last, with hits of this hash.
    Verdict compare(std::size_t number, Batch& batch, BatchTracer& tracer, std::uint64_t hash);

private:
    CpuBackend& backend_;
    Judge judge_;
    std::vector<HitStorage>& found_;
    std::map<std::pair<std::size_t, std::uint64_t>, Verdict> verdicts_;
};

}  // namespace ctpbench
