// The study of stability: every method on every stress workload that it can meet.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "measure/exam.h"
#include "stress/workload.h"
#include "wavefront/cuda_workload.h"
#include "wavefront/forest.h"
#include "wavefront/scene_view.h"

namespace ctpbench {

// A workload's scene with all that a tracer needs of it, and its oracle.
class StressBed {
public:
    StressBed(CpuBackend& backend, StressWorkload workload);

    const StressWorkload& workload() const { return workload_; }
    const SceneView& view() const { return view_; }
    const LayoutInput& layout() const { return layout_; }
    const Judge& judge() const { return judge_; }
    const ExactTracer& exact() const { return exact_; }
    // Throws Error(no_backend) where there is no device.
    CudaWorkload& cuda();

private:
    StressWorkload workload_;
    SceneView view_;
    Forest forest_;
    LayoutInput layout_;
    Judge judge_;
    ExactTracer exact_;
    std::vector<Batch> batches_;
    std::unique_ptr<CudaWorkload> cuda_;
};

// One line of the study, before it is run.
struct StabilityMethod {
    std::string kind;    // triangle, sphere, box, offset, bundle or yardstick
    std::string method;  // as configs name it
    std::string backend;
    bool is_default = false;  // whether it is what runs use that ask for nothing
    std::function<std::unique_ptr<BatchTracer>(StressBed&)> tracer;
    DepartureExam::Policy policy{};  // how it leaves surfaces; empty: it meets no workload of offsets

    // A bundle and a yardstick meet all workloads, the latter but for those of offsets.
    bool meets(const StressInfo& workload) const;
};

struct StabilityRow {
    std::string kind, method, backend;
    bool is_default;
    std::string workload;
    Accuracy accuracy;
};

// Runs the methods that can meet the workload on its first `rays` rays, and hands out each row as soon as it
// is there. `step` is told what is going on and the share of it that is done, and may throw to end it.
void run_stability(CpuBackend& backend, const StressInfo& info, std::uint64_t seed, std::uint32_t rays,
                   const std::vector<StabilityMethod>& methods,
                   const std::function<void(const std::string& what, double share)>& step,
                   const std::function<void(const StabilityRow&)>& row);

}  // namespace ctpbench
