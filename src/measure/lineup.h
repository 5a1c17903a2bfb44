// The contenders of one workload, laid out on demand. Those that differ only in how they are launched share
// one layout, those of Embree's that differ only in how they are called share its tree.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "measure/results.h"
#include "oracle/embree_scene.h"
#include "wavefront/intersector.h"
#include "wavefront/typed_scenes.h"

namespace ctpbench {

// What trees.csv says of one of our trees.
TreeResult describe(const Workload& workload, const std::string& kind, const Tree& tree,
                    std::size_t primitives);

class Lineup {
public:
    // All of these must outlive the lineup. Packs are of the instruction set `isa`. `step` is told what is
    // being made; trees of Embree's are added to the results.
    Lineup(const Workload& workload, const Scene& scene, TypedScenes& scenes, CpuBackend& backend,
           std::string isa, Results& results, std::function<void(const std::string&)> step)
        : workload_(workload),
          scene_(scene),
          scenes_(scenes),
          backend_(backend),
          isa_(std::move(isa)),
          results_(results),
          step_(std::move(step)) {}

    // `types`: one of type_choices(). Of Embree's, types, methods and traversal are no matter.
    const Intersector& get(const std::string& strategy, const std::string& methods, const std::string& types,
                           const std::string& traversal);

private:
    std::unique_ptr<Intersector> make(const std::string& strategy, const std::string& methods,
                                      const std::string& types, const std::string& traversal);
    std::shared_ptr<const EmbreeScene> embree_scene(EmbreeMode mode);

    const Workload& workload_;
    const Scene& scene_;
    TypedScenes& scenes_;
    CpuBackend& backend_;
    std::string isa_;
    Results& results_;
    std::function<void(const std::string&)> step_;
    std::map<EmbreeMode, std::shared_ptr<const EmbreeScene>> embree_scenes_;
    std::map<std::string, std::unique_ptr<Intersector>> made_;
};

}  // namespace ctpbench
