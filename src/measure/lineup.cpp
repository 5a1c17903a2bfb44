#include "measure/lineup.h"

#include <utility>

#include "oracle/embree.h"

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
                               const std::string& types) {
    std::unique_ptr<Intersector>& made = made_[strategy + "/" + methods + "/" + types];
    if (!made) made = make(strategy, methods, types);
    return *made;
}

std::unique_ptr<Intersector> Lineup::make(const std::string& strategy, const std::string& methods,
                                          const std::string& types) {
    for (const EmbreeContender& e : embree_contenders()) {
        if (e.name != strategy) continue;
        step_("building Embree's tree (" + e.name + ")");
        auto embree = make_embree(scene_, e.mode, threads_);
        TreeResult tree;
        tree.workload = workload_, tree.kind = strategy;
        tree.primitives = scene_.mesh.triangles.size() + scene_.spheres.size();
        tree.build_seconds = embree->build_seconds(), tree.bytes = embree->bytes();
        results_.trees.push_back(tree);
        return embree;
    }
    step_("laying out " + strategy);
    return make_intersector(strategy, methods, scenes_.layout(types));
}

}  // namespace ctpbench
