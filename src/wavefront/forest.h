// The trees of one scene: those that its contenders need, each built once and shared.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "accel/sbvh.h"
#include "backends/cpu.h"
#include "kernels/dispatch/layout.h"
#include "scene/scene.h"
#include "wavefront/type_choice.h"

namespace ctpbench {

struct BuilderInfo {
    std::string name;
    SbvhSettings settings;
};
// The builders that configs may name.
std::vector<BuilderInfo> tree_builders();

struct Forest {
    std::shared_ptr<const Tree> mixed, typed_leaves;
    std::vector<std::shared_ptr<const Tree>> per_type;  // by tag; null: the scene has none of the type

    // For contenders that are compiled for the primitives that the geometry has. The trees and the scene's
    // geometry must outlive what is laid out from this.
    LayoutInput layout_input(const GeometryView& geometry) const;
};

// Called with what is being built and the share of it that is done.
using ForestProgress = std::function<void(const std::string& tree, double fraction)>;

// Builds the trees of these kinds; where the scene has one type of primitives they are all the same one. A
// tree over triangles alone may be handed in: it does not depend on the spheres.
Forest build_forest(CpuBackend& backend, const Scene& scene, const std::set<TreeKind>& kinds,
                    const SbvhSettings& settings, std::shared_ptr<const Tree> triangles,
                    const ForestProgress& progress);

// The same of triangles of synthetic types. The scene has no spheres.
Forest build_synthetic_forest(CpuBackend& backend, const Scene& scene, const std::set<TreeKind>& kinds,
                              const SbvhSettings& settings, const TypeChoice& choice);

}  // namespace ctpbench
