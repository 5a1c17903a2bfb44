// A contender's frames on a CUDA device. The host launches a whole frame without reading anything back: how
// many paths are active is the device's own knowledge.
#pragma once

#include <memory>
#include <vector>

#include "kernels/generate.h"
#include "wavefront/cuda_stage_times.cuh"
#include "wavefront/cuda_workload.h"
#include "wavefront/device_intersector.cuh"
#include "wavefront/device_shader.cuh"
#include "wavefront/frame_graph.cuh"
#include "wavefront/placed_wavefront.h"

namespace ctpbench {

class CudaPipeline final : public FramePipeline {
public:
    // Intersector and buffers must outlive it.
    // The words are the device's, of the table that the shader was made from.
    CudaPipeline(const DeviceIntersector& intersector, std::unique_ptr<DeviceShader> shader,
                 const MaterialWords& words, CudaLaunch launch, PlacedWavefront& wavefront,
                 const SceneView& scene, const Camera& camera, const FrameSettings& settings);

    std::vector<StageTime> frame(bool carry_t, std::uint32_t sample, ImageStorage& image,
                                 const BounceObserver& observe) override;

private:
    void launch_frame(bool carry_t, std::uint32_t sample, const BounceObserver& observe);
    void generate(std::uint32_t sample);
    void intersect(std::uint32_t bounce, bool carry_t);
    void copy(std::uint32_t bounce);
    void sort(std::uint32_t bounce);
    void shade(std::uint32_t bounce, std::uint32_t sample);
    bool sorts() const;
    // By slot, what paths leave out; null if the shader does not exclude.
    std::uint32_t* excluded() const { return shader_->excludes() ? wavefront_.excluded : nullptr; }
    void compact(std::uint32_t bounce);
    void show(std::uint32_t bounce, const BounceObserver& observe);
    BounceCounts* counts(std::uint32_t bounce) const { return wavefront_.counts + bounce; }

    const DeviceIntersector& intersector_;
    std::unique_ptr<DeviceShader> shader_;
    MaterialWords words_;
    CudaLaunch launch_;
    PlacedWavefront& wavefront_;
    CameraFrame camera_;
    FrameSettings settings_;
    Vec3 ambient_;
    std::uint32_t current_ = 0;  // of the two index buffers

    DeviceStream stream_;
    std::vector<DeviceStream> streams_;  // of the kernels of one type each
    DeviceEvent forked_;
    std::vector<DeviceEvent> joined_;
    FrameClock clock_;
    ShadePartNames part_names_;
    FrameGraph graph_;
};

}  // namespace ctpbench
