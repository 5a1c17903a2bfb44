// Traces batches on a CUDA device.
#pragma once

#include "backends/device_event.cuh"
#include "wavefront/batch_tracer.h"
#include "wavefront/device_batches.cuh"
#include "wavefront/device_intersector.cuh"

namespace ctpbench {

class CudaTracer final : public BatchTracer {
public:
    // All must outlive it. `extent` is the scene's largest absolute coordinate.
    CudaTracer(const DeviceIntersector& intersector, DeviceBatches& batches, float extent)
        : intersector_(intersector), batches_(batches), extent_(extent) {}

    Traced trace(Batch& batch, bool carry_t) override {
        PlacedBatch& entry = batches_.get(batch);
        const auto n = static_cast<std::uint32_t>(batch.rays.size());
        IntersectBuffers io{entry.rays, batches_.hits(), entry.index, n, extent_};
        io.excluded = entry.excluded;
        begin_.record(stream_.get());
        intersector_.intersect(stream_.get(), io, {n}, carry_t);
        end_.record(stream_.get());
        end_.wait();
        traced_ = n;
        const double seconds = seconds_between(begin_, end_);
        if (entry.first_hash != 0 && batches_.same_as_first(entry, n)) return {seconds, entry.first_hash};
        const std::uint64_t hash = hits().hash();
        if (entry.first_hash == 0) {
            copy_columns(entry.first_hits, batches_.hits(), n);
            entry.first_hash = hash;
        }
        return {seconds, hash};
    }
    HitStorage& hits() override {
        host_hits_.resize(traced_);
        copy_columns(host_hits_.view(), batches_.hits(), traced_);
        return host_hits_;
    }

private:
    const DeviceIntersector& intersector_;
    DeviceBatches& batches_;
    float extent_;
    DeviceStream stream_;
    DeviceEvent begin_, end_;
    std::uint32_t traced_ = 0;
    HitStorage host_hits_;
};

}  // namespace ctpbench
