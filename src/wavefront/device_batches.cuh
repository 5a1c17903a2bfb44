// Recorded batches in a device's memory, copied once for all contenders, each with the hits that were found
// first and their hash. A contender's hits are compared there with those: they need not cross the bus to be
// known.
#pragma once

#include <map>
#include <memory>

#include "backends/cuda_launch.cuh"
#include "wavefront/batch.h"
#include "wavefront/device_columns.cuh"

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
    struct Entry {
        DeviceRays rays;
        DeviceArray<std::uint32_t> index;
        DeviceArray<std::uint32_t> excluded;  // empty if the batch has none
        DeviceHits first_hits;
        std::uint64_t first_hash = 0;  // 0: there are none yet
    };

    // The batch must stay where it is.
    Entry& get(Batch& batch) {
        std::unique_ptr<Entry>& entry = entries_[&batch];
        if (!entry) {
            const std::size_t n = batch.rays.size();
            entry = std::make_unique<Entry>();
            entry->rays = DeviceRays(n), entry->first_hits = DeviceHits(n);
            entry->index = DeviceArray<std::uint32_t>(batch.index.data(), n);
            if (!batch.excluded.empty())
                entry->excluded = DeviceArray<std::uint32_t>(batch.excluded.data(), n);
            copy_columns(entry->rays.view(), batch.rays.view(), n);
            if (hits_.size() < n) hits_ = DeviceHits(n);
        }
        return *entry;
    }
    // Where contenders leave their hits; every batch fits.
    HitColumns hits() const { return hits_.view(); }

    bool same_as_first(const Entry& entry, std::size_t n) {
        differ_.clear();
        launch_for_each(nullptr, {static_cast<std::uint32_t>(n)},
                        CompareHits{hits(), entry.first_hits.view(), differ_.data()}, "comparing hits");
        std::uint32_t differ = 0;
        differ_.download(&differ, 1);
        return differ == 0;
    }

private:
    std::map<const Batch*, std::unique_ptr<Entry>> entries_;
    DeviceHits hits_;
    DeviceArray<std::uint32_t> differ_{1};
};

}  // namespace ctpbench
