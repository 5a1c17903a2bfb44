// Recorded batches in a device's memory, copied once for all contenders, each with the hits that were found
// first and their hash. A contender's hits are compared there with those: they need not cross the bus to be
// known.
#pragma once

#include "kernels/platform.h"
#include "wavefront/device_copy.cuh"
#include "wavefront/device_place.cuh"
#include "wavefront/placed_batches.h"

namespace ctpbench {

// Sets the flag if any entry differs in any bit.
struct CompareHits {
    HitColumns a, b;
    std::uint32_t* differ;

    __device__ void operator()(std::uint32_t i) const {
        if (__float_as_uint(a.t[i]) != __float_as_uint(b.t[i]) || a.primitive[i] != b.primitive[i] ||
            __float_as_uint(a.u[i]) != __float_as_uint(b.u[i]) ||
            __float_as_uint(a.v[i]) != __float_as_uint(b.v[i]))
            *differ = 1;
    }
};

class DeviceBatches {
public:
    // All must outlive it, and the batches stay where they are.
    DeviceBatches(const DevicePlace& place, std::vector<Batch>& batches)
        : batches_(batches), placed_(batches_in(place, batches)) {
        for (Batch& batch : batches) copy_columns(get(batch).rays, batch.rays.view(), batch.rays.size());
    }

    PlacedBatch& get(const Batch& batch) {
        for (std::size_t i = 0; i < batches_.size(); ++i)
            if (&batches_[i] == &batch) return placed_.each[i];
        trap();
    }
    HitColumns hits() const { return placed_.hits; }

    bool same_as_first(const PlacedBatch& batch, std::size_t n) {
        check_cuda(cudaMemset(placed_.differ, 0, sizeof(std::uint32_t)), "comparing hits");
        launch_for_each(nullptr, {static_cast<std::uint32_t>(n)},
                        CompareHits{hits(), batch.first_hits, placed_.differ}, "comparing hits");
        std::uint32_t differ = 0;
        copy_column(&differ, placed_.differ, 1);
        return differ == 0;
    }

private:
    std::vector<Batch>& batches_;
    PlacedBatches placed_;
};

}  // namespace ctpbench
