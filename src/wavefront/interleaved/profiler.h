// What rays in flight do with a scene, counted and timed: how many steps each takes, and what they cost.
#pragma once

#include <memory>
#include <string>

#include "backends/cpu.h"
#include "kernels/dispatch/layout.h"
#include "kernels/interleaved/profile.h"
#include "wavefront/batch.h"

namespace ctpbench {

class FlightProfiler {
public:
    // Lays out strategy `typed_phases` for this instruction set, one of usable_isas(). The input's geometry
    // and trees must outlive it.
    FlightProfiler(CpuBackend& backend, const LayoutInput& input, const std::string& isa);

    // Traces the batch on the calling thread.
    FlightProfile trace(Batch& batch) const;

private:
    struct Tree;
    std::shared_ptr<const Tree> tree_;
    float extent_;
};

}  // namespace ctpbench
