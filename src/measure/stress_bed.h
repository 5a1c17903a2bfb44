// A stress workload's scene with its trees, what contenders are laid out from, and its oracle.
#pragma once

#include "oracle/exact_tracer.h"
#include "stress/workload.h"
#include "wavefront/typed_scenes.h"

namespace ctpbench {

class CpuBackend;

class StressBed {
public:
    StressBed(CpuBackend& backend, StressWorkload workload);

    const StressWorkload& workload() const { return workload_; }
    const SceneView& view() const { return view_; }
    TypedScenes& scenes() { return scenes_; }
    const LayoutInput& layout() { return scenes_.layout(kTypesOfScene); }
    const Judge& judge() const { return judge_; }
    const ExactTracer& exact() const { return exact_; }

private:
    StressWorkload workload_;
    SceneView view_;
    Forest forest_;
    TypedScenes scenes_;
    Judge judge_;
    ExactTracer exact_;
};

}  // namespace ctpbench
