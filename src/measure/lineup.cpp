#include "measure/lineup.h"

#include <utility>

#include "base/clock.h"
#include "oracle/embree.h"
#include "wavefront/interleaved/intersector.h"

namespace ctpbench {

TreeResult describe(const Workload& workload, const std::string& kind, const Tree& tree,
                    std::size_t primitives) {
    TreeResult r;
    r.workload = workload, r.kind = kind, r.primitives = primitives;
    r.nodes = tree.node_count(), r.references = tree.refs.size();
    r.depth = tree.depth, r.sah = tree.sah, r.build_seconds = tree.build_seconds;
    r.bytes = tree.nodes.size() * sizeof(BvhNode) + tree.refs.size() * sizeof(PrimitiveRef);
    r.hash = hash(tree);
    return r;
}

const Intersector& Lineup::get(const std::string& strategy, const std::string& methods,
                               const std::string& types, const std::string& traversal) {
    std::unique_ptr<Intersector>& made = made_[strategy + "/" + methods + "/" + types + "/" + traversal];
    if (!made) made = make(strategy, methods, types, traversal);
    return *made;
}

std::unique_ptr<Intersector> Lineup::make(const std::string& strategy, const std::string& methods,
                                          const std::string& types, const std::string& traversal) {
    for (const EmbreeContender& e : embree_contenders())
        if (e.name == strategy) return make_embree(embree_scene(e.mode), e.call, e.coherent);
    step_("laying out " + strategy + (traversal == kInterleaved ? ", " + traversal : ""));
    if (traversal == kInterleaved) {
        const LayoutInput& input = scenes_.layout(types);
        TreeResult wide;  // what comes on top of the binary tree that it is made from
        std::unique_ptr<Intersector> made;
        wide.build_seconds = seconds_of([&] { made = make_interleaved(backend_, strategy, input, isa_); });
        wide.workload = workload_, wide.kind = strategy + "/" + traversal;
        wide.primitives = scene_.mesh.triangles.size() + scene_.spheres.size(), wide.bytes = made->bytes();
        results_.trees.push_back(wide);
        return made;
    }
    return make_intersector(strategy, methods, scenes_.layout(types));
}

std::shared_ptr<const EmbreeScene> Lineup::embree_scene(EmbreeMode mode) {
    std::shared_ptr<const EmbreeScene>& scene = embree_scenes_[mode];
    if (scene) return scene;
    TreeResult tree;
    tree.workload = workload_, tree.kind = mode == EmbreeMode::robust ? "embree_robust" : "embree_default";
    step_("building Embree's tree (" + tree.kind + ")");
    scene = std::make_shared<const EmbreeScene>(scene_, mode, backend_.threads());
    tree.primitives = scene_.mesh.triangles.size() + scene_.spheres.size();
    tree.build_seconds = scene->build_seconds(), tree.bytes = scene->bytes();
    results_.trees.push_back(tree);
    return scene;
}

}  // namespace ctpbench
