#include "wavefront/device_demand.h"

#include <algorithm>

#include "base/error.h"
#include "kernels/yardstick/while_while.h"
#include "wavefront/counting_place.h"
#include "wavefront/intersector.h"
#include "wavefront/placed_batches.h"
#include "wavefront/placed_wavefront.h"
#include "wavefront/shader.h"

namespace ctpbench {

std::size_t bytes_demanded(const DeviceDemand& demand, TypedScenes& scenes,
                           const std::vector<Batch>& batches) {
    const CountingPlace place;
    batches_in(place, batches);
    for (const auto& [strategy, methods, types] : demand.intersectors) {
        const LayoutInput& layout = scenes.layout(types);
        if (strategy == WhileWhile::name)
            WhileWhile::Layout(layout).view(place);
        else
            make_intersector(strategy, methods, layout)->count(layout, place);
    }
    if (demand.frames) {
        PlacedWavefront wavefront =
            wavefront_in(place, scenes.view(), *demand.frames, shade_keys(demand, scenes));
        if (demand.excludes) add_excluded(place, wavefront);
    }
    std::set<const MaterialTable*> tables;
    for (const DeviceDemand::Shader& shader : demand.shaders) {
        const MaterialTable& table = scenes.materials(shader.types, shader.offset);
        if (tables.insert(&table).second) words_in(place, table);
        make_shader(shader.strategy, table, shader.offset)->count(table.input(), place);
    }
    return place.bytes();
}

std::uint32_t shade_keys(const DeviceDemand& demand, TypedScenes& scenes) {
    std::uint32_t keys = 0;
    for (const DeviceDemand::Shader& shader : demand.shaders)
        keys = std::max(keys, scenes.materials(shader.types, shader.offset).words().keys());
    return keys;
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
