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
    for (const auto& tree : per_type) input.per_type.push_back(view_of(tree));
    input.geometry = geometry;
    input.types = primitives_in(geometry);
    if (input.types == 0) input.types = kAllPrimitives;  // nothing to hit: no matter
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
    forest.per_type.resize(Primitives<Watertight>::size);
    std::shared_ptr<const Tree>& of_triangles = forest.per_type[primitive_tag<Triangle<Watertight>>];
    std::shared_ptr<const Tree>& of_spheres = forest.per_type[primitive_tag<Sphere<Watertight>>];
    const bool no_triangles = scene.mesh.triangles.empty(), no_spheres = scene.spheres.empty();
    const bool wanted_apart = kinds.count(TreeKind::per_type) > 0;
    if (!no_triangles && (wanted_apart || no_spheres))
        of_triangles =
            triangles ? std::move(triangles) : build(PrimitiveSet::triangles, settings, "triangles");
    if (!no_spheres && (wanted_apart || no_triangles))
        of_spheres = build(PrimitiveSet::spheres, settings, "spheres");

    if (kinds.count(TreeKind::mixed))
        forest.mixed = no_triangles && no_spheres ? std::make_shared<const Tree>()
                       : no_spheres               ? of_triangles
                       : no_triangles             ? of_spheres
                                                  : build(PrimitiveSet::all, settings, "mixed");
    if (kinds.count(TreeKind::typed_leaves)) {
        // Leaves name their type, and without the setting it is the first, which is that of triangles.
        SbvhSettings typed = settings;
        typed.single_type_leaves = true;
        forest.typed_leaves =
            no_spheres && !no_triangles ? of_triangles : build(PrimitiveSet::all, typed, "typed_leaves");
    }
    return forest;
}

Forest build_synthetic_forest(CpuBackend& backend, const Scene& scene, const std::set<TreeKind>& kinds,
                              const SbvhSettings& settings, const TypeChoice& choice) {
    std::vector<std::uint8_t> types;
    types.reserve(scene.mesh.triangles.size());
    for (std::uint32_t i = 0; i < scene.mesh.triangles.size(); ++i)
        types.push_back(synthetic_type(choice, synthetic_material(i)));
    const auto build = [&](const Scene& of, const std::vector<std::uint8_t>& typed, bool single_type_leaves) {
        SbvhSettings with = settings;
        with.single_type_leaves = single_type_leaves;
        return backend.execute([&] { return build_sbvh(ScenePrimitives(of, typed), with); });
    };
    Forest forest;
    if (kinds.count(TreeKind::mixed)) forest.mixed = std::make_shared<const Tree>(build(scene, types, false));
    if (kinds.count(TreeKind::typed_leaves))
        forest.typed_leaves = std::make_shared<const Tree>(build(scene, types, true));
    const std::uint32_t end = choice.first_used + choice.used;
    forest.per_type.resize(end);
    if (!kinds.count(TreeKind::per_type)) return forest;
    for (std::uint32_t type = choice.first_used; type < end; ++type) {
        Scene part;
        std::vector<std::uint32_t> index;  // in the scene
        for (std::uint32_t i = 0; i < types.size(); ++i)
            if (types[i] == type) part.mesh.triangles.push_back(scene.mesh.triangles[i]), index.push_back(i);
        if (index.empty()) continue;
        part.mesh.positions = scene.mesh.positions;
        Tree tree =
            build(part, std::vector<std::uint8_t>(index.size(), static_cast<std::uint8_t>(type)), false);
        for (PrimitiveRef& ref : tree.refs) ref.index = index[ref.index];
        forest.per_type[type] = std::make_shared<const Tree>(std::move(tree));
    }
    return forest;
}

}  // namespace ctpbench
