#include "measure/stress_bed.h"

#include <utility>

namespace ctpbench {
namespace {

// All of them: the scenes are small, and any strategy may be asked for.
const std::set<TreeKind> kTrees = {TreeKind::mixed, TreeKind::typed_leaves, TreeKind::per_type};

Forest trees_of(CpuBackend& backend, const Scene& scene) {
    return build_forest(backend, scene, kTrees, SbvhSettings::quality(), nullptr,
                        [](const std::string&, double) {});
}

}  // namespace

StressBed::StressBed(CpuBackend& backend, StressWorkload workload)
    : workload_(std::move(workload)),
      view_(workload_.scene),
      forest_(trees_of(backend, workload_.scene)),
      scenes_(backend, workload_.scene, view_, forest_, kTrees, SbvhSettings::quality()),
      judge_(view_.geometry()),
      exact_(judge_, *forest_.mixed) {}

}  // namespace ctpbench
