// What a workload's contenders ask of a CUDA device, and how many bytes that takes: counted before anything
// is allocated there (counting_place.h), so that a run which does not fit ends before it has begun. Needs no
// device.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "backends/cuda.h"
#include "kernels/dispatch/layout.h"
#include "wavefront/batch.h"
#include "wavefront/frame.h"
#include "wavefront/scene_view.h"

namespace ctpbench {

struct DeviceDemand {
    std::set<std::pair<std::string, std::string>>
        intersectors;                     // strategy, methods: shared by all that have both
    std::vector<std::string> shaders;     // of each pipeline
    std::optional<FrameSettings> frames;  // none: there are no pipelines
    bool excludes = false;                // whether paths of one leave out what they come from
};

// Of a CudaWorkload with these contenders. Lays them out as the workload will, on the host and one at a time.
std::size_t bytes_demanded(const DeviceDemand& demand, const SceneView& scene, const LayoutInput& layout,
                           const std::vector<Batch>& batches);

// Throws Error(no_backend) with the bytes needed and free unless `bytes` fit beside what the driver takes.
void require_device_memory(const std::string& workload, std::size_t bytes, const CudaMemory& memory);

}  // namespace ctpbench
