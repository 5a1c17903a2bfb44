#include "wavefront/forest.h"

#include <utility>

#include "accel/scene_primitives.h"

namespace ctpbench {
namespace {

TreeView view_of(const std::shared_ptr<const Tree>& tree) {
    if (!tree) return {};
    return {tree->nodes.data(), tree->refs.data(), tree->nodes.size(), tree->refs.size()};
}

}  // namespace

std::vector<BuilderInfo> tree_builders() {
    return {{"paper", SbvhSettings::paper()}, {"quality", SbvhSettings::quality()}};
}

LayoutInput Forest::layout_input(const GeometryView& geometry) const {
    LayoutInput input;
    input.mixed = view_of(mixed);
    input.typed_leaves = view_of(typed_leaves);
    for (std::size_t type = 0; type < kPrimitiveTypes; ++type) input.per_type[type] = view_of(per_type[type]);
    input.geometry = geometry;
    return input;
}

Forest build_forest(CpuBackend& backend, const Scene& scene, const std::set<TreeKind>& kinds,
                    const SbvhSettings& settings, std::shared_ptr<const Tree> triangles,
                    const ForestProgress& progress) {
    const auto build = [&](PrimitiveSet which, const SbvhSettings& with, const std::string& name) {
        return backend.execute([&] {
            return std::make_shared<const Tree>(
                build_sbvh(ScenePrimitives(scene, which), with, [&](double done) { progress(name, done); }));
        });
    };
    Forest forest;
    if (kinds.count(TreeKind::mixed)) forest.mixed = build(PrimitiveSet::all, settings, "mixed");
    if (kinds.count(TreeKind::typed_leaves)) {
        SbvhSettings typed = settings;
        typed.single_type_leaves = true;
        forest.typed_leaves = build(PrimitiveSet::all, typed, "typed_leaves");
    }
    if (kinds.count(TreeKind::per_type)) {
        forest.per_type[0] =
            triangles ? std::move(triangles) : build(PrimitiveSet::triangles, settings, "triangles");
        forest.per_type[1] = build(PrimitiveSet::spheres, settings, "spheres");
    }
    return forest;
}

}  // namespace ctpbench
