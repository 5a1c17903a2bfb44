#include "wavefront/cuda_workload.h"

#include <map>

#include "wavefront/cuda_pipeline.cuh"
#include "wavefront/cuda_tracer.cuh"

namespace ctpbench {
namespace {

class Workload final : public CudaWorkload {
public:
    Workload(const SceneView& scene, const LayoutInput& layout) : scene_(scene), layout_(layout) {}

    std::unique_ptr<BatchTracer> tracer(const std::string& strategy, const std::string& methods) override {
        return std::make_unique<CudaTracer>(intersector(strategy, methods), batches_,
                                            scene_.geometry().extent);
    }
    std::unique_ptr<FramePipeline> pipeline(const std::string& strategy, const std::string& methods,
                                            const std::string& shade, CudaLaunch launch, const Camera& camera,
                                            const FrameSettings& settings,
                                            const std::string& offset) override {
        if (!wavefront_) wavefront_ = std::make_unique<DeviceWavefront>(scene_, settings);
        return std::make_unique<CudaPipeline>(intersector(strategy, methods),
                                              make_device_shader(shade, scene_.materials(), offset), launch,
                                              *wavefront_, scene_, camera, settings);
    }

private:
    const DeviceIntersector& intersector(const std::string& strategy, const std::string& methods) {
        auto& made = intersectors_[strategy + "/" + methods];
        if (!made) made = make_device_intersector(strategy, methods, layout_);
        return *made;
    }

    const SceneView& scene_;
    const LayoutInput& layout_;
    DeviceBatches batches_;
    std::unique_ptr<DeviceWavefront> wavefront_;
    std::map<std::string, std::unique_ptr<DeviceIntersector>> intersectors_;
};

}  // namespace

std::unique_ptr<CudaWorkload> make_cuda_workload(const SceneView& scene, const LayoutInput& layout) {
    return std::make_unique<Workload>(scene, layout);
}

}  // namespace ctpbench
