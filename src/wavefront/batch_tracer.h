// One contender of the intersect contest on one backend: it traces recorded batches, wherever that happens.
#pragma once

#include <cstdint>

#include "wavefront/batch.h"

namespace ctpbench {

class BatchTracer {
public:
    struct Traced {
        double seconds;      // of the kernels alone
        std::uint64_t hash;  // of the hits
    };

    virtual ~BatchTracer() = default;
    // The batch must be the same, at the same address, in every call about it.
    virtual Traced trace(Batch& batch, bool carry_t) = 0;
    // The hits of the last batch traced, in the host's memory.
    virtual HitStorage& hits() = 0;
};

}  // namespace ctpbench
