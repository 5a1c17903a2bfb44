#include "wavefront/cuda_workload.h"

#include <map>

#include "wavefront/cuda_pipeline.cuh"
#include "wavefront/cuda_tracer.cuh"

namespace ctpbench {
namespace {

class Workload final : public CudaWorkload {
public:
    Workload(TypedScenes& scenes, std::vector<Batch>& batches, std::uint32_t shade_keys)
        : scenes_(scenes), shade_keys_(shade_keys), batches_(place_, batches) {}

    std::unique_ptr<BatchTracer> tracer(const std::string& strategy, const std::string& methods,
                                        const std::string& types) override {
        return std::make_unique<CudaTracer>(intersector(strategy, methods, types), batches_,
                                            scenes_.view().geometry().extent);
    }
    std::unique_ptr<FramePipeline> pipeline(const std::string& strategy, const std::string& methods,
                                            const std::string& types, const std::string& shade,
                                            CudaLaunch launch, const Camera& camera,
                                            const FrameSettings& settings,
                                            const std::string& offset) override {
        if (!wavefront_)
            wavefront_ = std::make_unique<PlacedWavefront>(
                wavefront_in(place_, scenes_.view(), settings, shade_keys_));
        const MaterialTable& table = scenes_.materials(types, offset);
        auto shader = make_device_shader(place_, shade, table.input(), offset);
        if (shader->excludes()) add_excluded(place_, *wavefront_);
        return std::make_unique<CudaPipeline>(intersector(strategy, methods, intersected_on_device(types)),
                                              std::move(shader), words(table), launch, *wavefront_,
                                              scenes_.view(), camera, settings);
    }
    std::size_t bytes() const override { return place_.bytes(); }

private:
    const DeviceIntersector& intersector(const std::string& strategy, const std::string& methods,
                                         const std::string& types) {
        auto& made = intersectors_[strategy + "/" + methods + "/" + types];
        if (!made) made = make_device_intersector(place_, strategy, methods, scenes_.layout(types));
        return *made;
    }
    const MaterialWords& words(const MaterialTable& table) {
        const auto [known, added] = words_.try_emplace(&table);
        if (added) known->second = words_in(place_, table);
        return known->second;
    }

    TypedScenes& scenes_;
    std::uint32_t shade_keys_;
    DevicePlace place_;  // of all that follows
    DeviceBatches batches_;
    std::unique_ptr<PlacedWavefront> wavefront_;
    std::map<std::string, std::unique_ptr<DeviceIntersector>> intersectors_;
    std::map<const MaterialTable*, MaterialWords> words_;
};

}  // namespace

std::unique_ptr<CudaWorkload> make_cuda_workload(TypedScenes& scenes, std::vector<Batch>& batches,
                                                 std::uint32_t shade_keys) {
    return std::make_unique<Workload>(scenes, batches, shade_keys);
}

}  // namespace ctpbench
