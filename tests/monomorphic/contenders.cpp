#include "monomorphic/contenders.h"

#include <algorithm>
#include <stdexcept>

#include "monomorphic/matte_shader.h"
#include "monomorphic/triangle_intersector.h"
#include "wavefront/typed_scenes.h"

namespace ctpbench::monomorphic {
namespace {

StrategyInfo find_strategy(const std::string& name) {
    std::string known;
    for (const StrategyInfo& s : intersect_strategies()) {
        if (s.name == name) return s;
        known += " " + s.name;
    }
    throw std::invalid_argument("no intersect strategy \"" + name + "\"; there are:" + known);
}

}  // namespace

Stage::Stage(const Scene& scene_, int threads, const std::set<TreeKind>& kinds)
    : scene(scene_),
      view(scene),
      backend(threads),
      forest(build_forest(backend, scene, kinds, SbvhSettings::quality(), nullptr,
                          [](const std::string&, double) {})),
      materials(scene, material_types(kTypesOfScene, WaechterBinder::name, needs_of(scene))) {}

std::unique_ptr<Intersector> intersector_of(const Stage& stage, const std::string& name) {
    const LayoutInput input = stage.forest.layout_input(stage.view.geometry());
    if (name == kByHand) return std::make_unique<TriangleIntersector>(input);
    return make_intersector(find_strategy(name).name, Watertight::name, input);
}

std::unique_ptr<Shader> shader_of(const Stage& stage, const std::string& name) {
    if (name == kByHand) return std::make_unique<MatteShader>(stage.scene);
    const std::vector<std::string> known = shade_strategies();
    if (std::find(known.begin(), known.end(), name) == known.end())
        throw std::invalid_argument("no shade strategy \"" + name + "\"");
    return make_shader(name, stage.materials);
}

std::set<TreeKind> trees_of(const std::vector<std::string>& names) {
    std::set<TreeKind> kinds = {TreeKind::mixed};
    for (const std::string& name : names)
        if (name != kByHand) kinds.insert(find_strategy(name).tree);
    return kinds;
}

}  // namespace ctpbench::monomorphic
