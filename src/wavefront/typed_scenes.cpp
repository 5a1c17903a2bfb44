#include "wavefront/typed_scenes.h"

#include <utility>

#include "base/error.h"
#include "base/type_names.h"
#include "kernels/registry.h"

namespace ctpbench {
namespace {

// `matte+plastic`
std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : "+") + name;
    return text;
}

// Whether kernels with this offset are compiled for fewer than all types.
bool narrows(const std::string& offset) {
    bool any = false;
    for_each_type(Offsets{}, [&](auto tag) {
        using Offset = typename decltype(tag)::type;
        any |= offset == Offset::name && narrows_materials<Offset>;
    });
    return any;
}

// A scene without anything to hit or to shade is as good as any.
std::uint32_t primitive_mask(const std::string& types, const SceneNeeds& needs) {
    return type_choice(types).narrowed && needs.primitives != 0 ? needs.primitives : kAllPrimitives;
}

}  // namespace

MaterialTypes material_types(const std::string& types, const std::string& offset, const SceneNeeds& needs) {
    if (!type_choice(types).narrowed || !narrows(offset) || needs.materials == 0) return {};
    return {needs.materials, needs.textured && (needs.materials & kTexturable) != 0};
}

std::string primitive_list(const std::string& types, const SceneNeeds& needs) {
    if (type_choice(types).synthetic.any()) return {};
    return joined(names_of<Primitives<Watertight>>(primitive_mask(types, needs)));
}

std::string material_list(const std::string& types, const std::string& offset, const SceneNeeds& needs) {
    if (type_choice(types).synthetic.any()) return {};
    const MaterialTypes known = material_types(types, offset, needs);
    return joined(names_of<Materials>(known.mask)) + (known.textured ? ", textured" : "");
}

TypedScenes::TypedScenes(CpuBackend& backend, const Scene& scene, const SceneView& view, const Forest& forest,
                         std::set<TreeKind> kinds, const SbvhSettings& settings)
    : backend_(backend),
      scene_(scene),
      view_(view),
      forest_(forest),
      kinds_(std::move(kinds)),
      settings_(settings),
      needs_(needs_of(scene)) {}

const LayoutInput& TypedScenes::layout(const std::string& types) {
    const auto [known, added] = layouts_.try_emplace(types);
    LayoutInput& input = known->second;
    if (!added) return input;
    const TypeChoice choice = type_choice(types);
    if (!choice.synthetic.any()) {
        input = forest_.layout_input(view_.geometry());
        input.types = primitive_mask(types, needs_);
        return input;
    }
    if (!scene_.spheres.empty())
        throw Error(ExitCode::usage, "scene \"" + scene_.name + "\": error: has " +
                                         std::to_string(scene_.spheres.size()) + " spheres, but types \"" +
                                         types +
                                         "\" are triangles; set /matrix/spheres to 0, or choose a scene that "
                                         "has none of its own");
    // What the list holds besides is of no matter to the trees.
    const auto [forest, planted] =
        synthetic_forests_.try_emplace(std::to_string(choice.first_used) + "+" + std::to_string(choice.used));
    if (planted) forest->second = build_synthetic_forest(backend_, scene_, kinds_, settings_, choice);
    input = forest->second.layout_input(view_.geometry());
    input.per_type.resize(choice.synthetic.listed);
    input.synthetic = choice.synthetic;
    return input;
}

const MaterialTable& TypedScenes::materials(const std::string& types, const std::string& offset) {
    const TypeChoice choice = type_choice(types);
    const MaterialTypes known = material_types(types, offset, needs_);
    const std::string key =
        choice.synthetic.any() ? types : std::to_string(known.mask) + (known.textured ? " textured" : "");
    std::unique_ptr<MaterialTable>& table = tables_[key];
    if (!table)
        table = choice.synthetic.any() ? std::make_unique<MaterialTable>(scene_, choice)
                                       : std::make_unique<MaterialTable>(scene_, known);
    return *table;
}

}  // namespace ctpbench
