#include "wavefront/cuda_workload.h"

#include <map>

#include "wavefront/cuda_pipeline.cuh"
#include "wavefront/cuda_tracer.cuh"

namespace ctpbench {
namespace {

class Workload final : public CudaWorkload {
public:
    Workload(const SceneView& scene, const LayoutInput& layout, std::vector<Batch>& batches)
        : scene_(scene), layout_(layout), batches_(place_, batches) {}

    std::unique_ptr<BatchTracer> tracer(const std::string& strategy, const std::string& methods) override {
        return std::make_unique<CudaTracer>(intersector(strategy, methods), batches_,
                                            scene_.geometry().extent);
    }
    std::unique_ptr<FramePipeline> pipeline(const std::string& strategy, const std::string& methods,
                                            const std::string& shade, CudaLaunch launch, const Camera& camera,
                                            const FrameSettings& settings,
                                            const std::string& offset) override {
        if (!wavefront_)
            wavefront_ = std::make_unique<PlacedWavefront>(wavefront_in(place_, scene_, settings));
        auto shader = make_device_shader(place_, shade, scene_.materials(), offset);
        if (shader->excludes()) add_excluded(place_, *wavefront_);
        return std::make_unique<CudaPipeline>(intersector(strategy, methods), std::move(shader), launch,
                                              *wavefront_, scene_, camera, settings);
    }
    std::size_t bytes() const override { return place_.bytes(); }

private:
    const DeviceIntersector& intersector(const std::string& strategy, const std::string& methods) {
        auto& made = intersectors_[strategy + "/" + methods];
        if (!made) made = make_device_intersector(place_, strategy, methods, layout_);
        return *made;
    }

    const SceneView& scene_;
    const LayoutInput& layout_;
    DevicePlace place_;  // of all that follows
    DeviceBatches batches_;
    std::unique_ptr<PlacedWavefront> wavefront_;
    std::map<std::string, std::unique_ptr<DeviceIntersector>> intersectors_;
};

}  // namespace

std::unique_ptr<CudaWorkload> make_cuda_workload(const SceneView& scene, const LayoutInput& layout,
                                                 std::vector<Batch>& batches) {
    return std::make_unique<Workload>(scene, layout, batches);
}

}  // namespace ctpbench
