// The wavefront path tracer of the paper's Figure 2: progressive frames, each a sample per pixel, traced
// bounce by bounce, with every stage a parallel kernel that is timed.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "backends/cpu.h"
#include "kernels/generate.h"
#include "wavefront/compaction.h"
#include "wavefront/frame.h"
#include "wavefront/intersector.h"
#include "wavefront/scene_view.h"
#include "wavefront/shader.h"
#include "wavefront/sorting.h"

namespace ctpbench {

class Renderer {
public:
    // The scene must outlive it.
    Renderer(CpuBackend& backend, const SceneView& scene, const Camera& camera,
             const FrameSettings& settings);

    // Traces sample number `sample` of every pixel and blends it into the image, which holds the samples
    // before it. `carry_t`: as in Intersector. The observer may be empty. A shader that excludes takes an
    // intersector that does.
    std::vector<StageTime> frame(const Intersector& intersector, const Shader& shader, bool carry_t,
                                 std::uint32_t sample, ImageStorage& image, const BounceObserver& observe);

    const FrameSettings& settings() const { return settings_; }
    std::uint32_t pixels() const { return settings_.width * settings_.height; }

private:
    template <class F>
    StageTime& time(const char* kernel, std::uint32_t bounce, F&& stage);
    void generate(std::uint32_t sample);
    void intersect(std::uint32_t bounce, const Intersector& intersector, PathOrder order, bool carry_t);
    void copy(std::uint32_t bounce);
    void sort(std::uint32_t bounce, PathOrder order);
    void shade(std::uint32_t bounce, std::uint32_t sample, const Shader& shader);
    void compact(std::uint32_t bounce, PathOrder order);
    void blend(std::uint32_t sample, ImageStorage& image);
    PathQueues queues();
    void show(std::uint32_t bounce, PathOrder order, const BounceObserver& observe);

    CpuBackend& backend_;
    const SceneView& scene_;
    CameraFrame camera_;
    FrameSettings settings_;

    RayStorage rays_;
    HitStorage hits_;
    PixelStorage pixels_;
    Array<std::uint32_t> index_, reordered_;  // slots of active paths; scratch for the stage that reorders
    Array<std::uint32_t> excluded_;           // by slot; empty until a shader needs it
    std::uint32_t* exclude_ = nullptr;        // the same during a frame whose shader needs it, else null
    Array<std::uint32_t> copied_;       // what the yardstick copies, and to where; touched by nobody else
    Array<std::uint8_t> keys_, fates_;  // by position in the index
    Array<std::uint32_t> positions_;    // 0, 1, 2, ...: what is sorted where the index stays
    std::uint32_t active_ = 0;
    MaterialWords words_{};  // the shader's
    ShadeWork work_{};
    Sorting sorting_;
    Compaction compaction_;

    std::uint32_t segments_;  // the rest is for queues
    Array<std::uint32_t> queue_slots_;
    Array<std::uint32_t> queue_counts_;
    Array<std::uint32_t> segment_counts_, dropped_counts_;

    std::vector<StageTime> times_;
};

// A contender's pipeline on CPU threads. The intersector must outlive it.
class CpuPipeline final : public FramePipeline {
public:
    CpuPipeline(std::shared_ptr<Renderer> renderer, const Intersector& intersector,
                std::unique_ptr<Shader> shader)
        : renderer_(std::move(renderer)), intersector_(intersector), shader_(std::move(shader)) {}

    std::vector<StageTime> frame(bool carry_t, std::uint32_t sample, ImageStorage& image,
                                 const BounceObserver& observe) override {
        return renderer_->frame(intersector_, *shader_, carry_t, sample, image, observe);
    }

private:
    std::shared_ptr<Renderer> renderer_;
    const Intersector& intersector_;
    std::unique_ptr<Shader> shader_;
};

}  // namespace ctpbench
