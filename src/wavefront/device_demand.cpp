#include "wavefront/device_demand.h"

#include "base/error.h"
#include "wavefront/counting_place.h"
#include "wavefront/placed_batches.h"
#include "wavefront/placed_layouts.h"
#include "wavefront/placed_materials.h"
#include "wavefront/placed_wavefront.h"

namespace ctpbench {

std::size_t bytes_demanded(const DeviceDemand& demand, const SceneView& scene, const LayoutInput& layout,
                           const std::vector<Batch>& batches) {
    const CountingPlace place;
    batches_in(place, batches);
    for (const auto& [strategy, methods] : demand.intersectors)
        visit_intersect_strategy(strategy, methods, [&](auto tag, auto bundle) {
            layout_in<typename decltype(tag)::type, typename decltype(bundle)::type>(place, layout);
        });
    if (demand.frames) {
        PlacedWavefront wavefront = wavefront_in(place, scene, *demand.frames);
        if (demand.excludes) add_excluded(place, wavefront);
    }
    for (const std::string& name : demand.shaders)
        for_each_type(ShadeStrategies{}, [&](auto tag) {
            using Strategy = typename decltype(tag)::type;
            if (name == Strategy::name) materials_in<Strategy>(place, scene.materials());
        });
    return place.bytes();
}

void require_device_memory(const std::string& workload, std::size_t bytes, const CudaMemory& memory) {
    if (bytes + memory.beside <= memory.free) return;
    throw Error(ExitCode::no_backend,
                "backend cuda: error: " + workload +
                    " does not fit the device's memory: " + std::to_string(bytes) + " bytes needed, and " +
                    std::to_string(memory.beside) + " for stacks and code; " + std::to_string(memory.free) +
                    " of " + std::to_string(memory.total) +
                    " free; use fewer pixels, fewer spheres, a smaller batch_rays or fewer contenders at a "
                    "time (--filter), or choose --backend cpu");
}

}  // namespace ctpbench
