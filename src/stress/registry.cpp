#include "stress/registry.h"

#include "base/error.h"
#include "stress/families.h"

namespace ctpbench {

const std::vector<StressInfo>& stress_workloads() {
    static const std::vector<StressInfo> all = [] {
        std::vector<StressInfo> list;
        for (const auto& family :
             {star_workloads(), star_layer_workloads(), sliver_workloads(), grid_workloads(),
              heap_workloads(), ball_workloads(), departure_workloads()})
            list.insert(list.end(), family.begin(), family.end());
        return list;
    }();
    return all;
}

StressWorkload make_stress(std::string_view name, std::uint64_t seed) {
    std::string choices;
    for (const StressInfo& info : stress_workloads()) {
        if (info.name == name) {
            StressWorkload workload = info.make(seed);
            workload.name = workload.scene.name = info.name;
            return workload;
        }
        choices += " " + info.name;
    }
    throw Error(ExitCode::usage,
                "there is no stress workload \"" + std::string(name) + "\"; choose from:" + choices);
}

}  // namespace ctpbench
