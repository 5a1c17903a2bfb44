// A workload as contenders see it that are compiled for different types: for each value of the axis `types`
// the trees and the table of materials that they lay out from, made when first asked for and shared.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>

#include "scene/needs.h"
#include "wavefront/forest.h"
#include "wavefront/material_table.h"
#include "wavefront/scene_view.h"

namespace ctpbench {

class TypedScenes {
public:
    // All must outlive it. `forest` has the scene's trees of these kinds; synthetic types get trees of the
    // same kinds and settings.
    TypedScenes(CpuBackend& backend, const Scene& scene, const SceneView& view, const Forest& forest,
                std::set<TreeKind> kinds, const SbvhSettings& settings);

    // `types` is one of type_choices(). Throws Error(usage) where the scene cannot be had with these types.
    const LayoutInput& layout(const std::string& types);
    // For the offset of that name: not every kernel is compiled for every list of materials.
    const MaterialTable& materials(const std::string& types, const std::string& offset);

    const SceneView& view() const { return view_; }

private:
    CpuBackend& backend_;
    const Scene& scene_;
    const SceneView& view_;
    const Forest& forest_;
    std::set<TreeKind> kinds_;
    SbvhSettings settings_;
    SceneNeeds needs_;
    std::map<std::string, Forest> synthetic_forests_;  // by the types that the scene has
    std::map<std::string, LayoutInput> layouts_;
    std::map<std::string, std::unique_ptr<MaterialTable>> tables_;
};

// What a contender is compiled for where the scene has these materials: exactly those, unless `types` asks
// for all or the offset is one whose kernels always have all.
MaterialTypes material_types(const std::string& types, const std::string& offset, const SceneNeeds& needs);

// For tables: `triangle+sphere`; `matte+plastic, textured`; empty for synthetic types.
std::string primitive_list(const std::string& types, const SceneNeeds& needs);
std::string material_list(const std::string& types, const std::string& offset, const SceneNeeds& needs);

}  // namespace ctpbench
