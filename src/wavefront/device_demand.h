// What a workload's contenders ask of a CUDA device, and how many bytes that takes: counted before anything
// is allocated there (counting_place.h), so that a run which does not fit ends before it has begun. Needs no
// device.
#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "backends/cuda.h"
#include "wavefront/batch.h"
#include "wavefront/frame.h"
#include "wavefront/typed_scenes.h"

namespace ctpbench {

struct DeviceDemand {
    struct Shader {
        std::string strategy, types, offset;
    };
    // Strategy, methods, types: shared by all that have the same.
    std::set<std::array<std::string, 3>> intersectors;
    std::vector<Shader> shaders;          // of each pipeline
    std::optional<FrameSettings> frames;  // none: there are no pipelines
    bool excludes = false;                // whether paths of one leave out what they come from
};

// Of a CudaWorkload with these contenders. Lays them out as the workload will, on the host and one at a time.
std::size_t bytes_demanded(const DeviceDemand& demand, TypedScenes& scenes,
                           const std::vector<Batch>& batches);

// The most keys that any of these shaders tells paths apart by.
std::uint32_t shade_keys(const DeviceDemand& demand, TypedScenes& scenes);

// Throws Error(no_backend) with the bytes needed and free unless `bytes` fit beside what the driver takes.
void require_device_memory(const std::string& workload, std::size_t bytes, const CudaMemory& memory);

}  // namespace ctpbench
