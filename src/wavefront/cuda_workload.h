// A workload's scene, trees and batches on a CUDA device, and its contenders there. Plain C++ to its users.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "kernels/methods/offset_waechter_binder.h"
#include "wavefront/batch_tracer.h"
#include "wavefront/frame.h"
#include "wavefront/typed_scenes.h"

namespace ctpbench {

// How a frame's kernels are launched. Isolated: one after another in one stream, so that each stage's time is
// its own. Concurrent: a shade kernel per type, each in a stream of its own. Graph: as concurrent, the whole
// frame captured once as a graph and launched by one call.
enum class CudaLaunch { isolated, concurrent, graph };

// By its name in configs.
inline CudaLaunch cuda_launch(const std::string& name) {
    return name == "graph"        ? CudaLaunch::graph
           : name == "concurrent" ? CudaLaunch::concurrent
                                  : CudaLaunch::isolated;
}

class CudaWorkload {
public:
    virtual ~CudaWorkload() = default;
    // Names must be registered. What differs only in how it is launched shares its layout. Traces the batches
    // of this workload alone.
    virtual std::unique_ptr<BatchTracer> tracer(const std::string& strategy, const std::string& methods,
                                                const std::string& types) = 0;
    // All pipelines of a workload have frames of the same size. `offset`: as in make_shader().
    virtual std::unique_ptr<FramePipeline> pipeline(const std::string& strategy, const std::string& methods,
                                                    const std::string& types, const std::string& shade,
                                                    CudaLaunch launch, const Camera& camera,
                                                    const FrameSettings& settings,
                                                    const std::string& offset = WaechterBinder::name) = 0;
    // Of the device's memory, as bytes_demanded() counts them.
    virtual std::size_t bytes() const = 0;
};

// All of these must outlive it, and the batches stay where they are. `shade_keys`: as in device_demand.h. The
// device is that which use_cuda_device() has chosen.
std::unique_ptr<CudaWorkload> make_cuda_workload(TypedScenes& scenes, std::vector<Batch>& batches,
                                                 std::uint32_t shade_keys);

// The yardsticks that CUDA has.
inline constexpr const char* kCudaYardstick = "while_while";

}  // namespace ctpbench
