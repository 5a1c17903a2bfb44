// Traces batches on CPU threads.
#pragma once

#include "base/clock.h"
#include "wavefront/batch_tracer.h"
#include "wavefront/intersector.h"

namespace ctpbench {

class CpuTracer final : public BatchTracer {
public:
    // Both must outlive it. `extent` is the scene's largest absolute coordinate.
    CpuTracer(CpuBackend& backend, const Intersector& intersector, float extent)
        : backend_(backend), intersector_(intersector), extent_(extent) {}

    Traced trace(Batch& batch, bool carry_t) override {
        const IntersectBuffers io = batch_buffers(batch, hits_, extent_);
        const double seconds = seconds_of([&] { intersector_.intersect(backend_, io, carry_t); });
        return {seconds, hits_.hash()};
    }
    HitStorage& hits() override { return hits_; }

private:
    CpuBackend& backend_;
    const Intersector& intersector_;
    float extent_;
    HitStorage hits_;
};

}  // namespace ctpbench
