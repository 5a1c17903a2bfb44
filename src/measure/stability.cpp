#include "measure/stability.h"

#include <algorithm>
#include <optional>

#include "stress/registry.h"

namespace ctpbench {
namespace {

// Shares of a workload's time: its trees, its reference; methods have the rest.
constexpr double kTrees = 0.05, kReference = 0.4;

Forest trees_of(CpuBackend& backend, const Scene& scene) {
    return build_forest(backend, scene, {TreeKind::mixed, TreeKind::per_type}, SbvhSettings::quality(),
                        nullptr, [](const std::string&, double) {});
}

}  // namespace

StressBed::StressBed(CpuBackend& backend, StressWorkload workload)
    : workload_(std::move(workload)),
      view_(workload_.scene),
      forest_(trees_of(backend, workload_.scene)),
      layout_(forest_.layout_input(view_.geometry())),
      judge_(view_.geometry()),
      exact_(judge_, *forest_.mixed) {}

CudaWorkload& StressBed::cuda() {
    if (!cuda_) cuda_ = make_cuda_workload(view_, layout_, batches_);
    return *cuda_;
}

bool StabilityMethod::meets(const StressInfo& info) const {
    const StressKinds& k = info.kinds;
    if (k.offset) return static_cast<bool>(policy) && (kind == "offset" || kind == "bundle");
    if (kind == "bundle" || kind == "yardstick") return true;
    return (kind == "triangle" && k.triangle) || (kind == "sphere" && k.sphere) || (kind == "box" && k.box);
}

void run_stability(CpuBackend& backend, const StressInfo& info, std::uint64_t seed, std::uint32_t rays,
                   const std::vector<StabilityMethod>& methods,
                   const std::function<void(const std::string& what, double share)>& step,
                   const std::function<void(const StabilityRow&)>& row) {
    std::vector<const StabilityMethod*> meeting;
    for (const StabilityMethod& m : methods)
        if (m.meets(info)) meeting.push_back(&m);
    if (meeting.empty()) return;
    step("building the trees", 0.0);
    StressBed bed(backend, make_stress(info.name, seed));
    const auto safe_point = [&] { step("tracing the reference", kTrees); };
    safe_point();
    Batch batch;
    std::optional<RayExam> of_rays;
    std::optional<DepartureExam> of_paths;
    if (info.kinds.offset) {
        of_paths.emplace(backend, bed.judge(), bed.exact(), bed.workload(), rays, safe_point);
    } else {
        batch = stress_batch(backend, rays, bed.workload().ray);
        of_rays.emplace(backend, bed.judge(), bed.exact(), batch, safe_point);
    }
    for (std::size_t i = 0; i < meeting.size(); ++i) {
        const StabilityMethod& m = *meeting[i];
        step("judging " + m.kind + " " + m.method + " on " + m.backend,
             kReference + (1.0 - kReference) * static_cast<double>(i) / static_cast<double>(meeting.size()));
        const std::unique_ptr<BatchTracer> tracer = m.tracer(bed);
        row({m.kind, m.method, m.backend, m.is_default, info.name,
             of_paths ? of_paths->take(*tracer, m.policy) : of_rays->take(*tracer)});
    }
}

}  // namespace ctpbench
