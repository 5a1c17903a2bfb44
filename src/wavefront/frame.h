// Frames: what is asked of a pipeline, and what it says of its stages, whatever backend it runs on.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "kernels/roulette.h"
#include "wavefront/columns.h"

namespace ctpbench {

struct FrameSettings {
    std::uint32_t width, height;
    std::uint32_t bounces;  // intersections after the camera ray's
    std::uint64_t seed;
    bool copies = false;  // whether to time a plain copy of the index buffer at each bounce (a yardstick)
    // The bounce from which on paths must survive roulette (kernels/roulette.h); 0 is the camera ray's hit.
    std::uint32_t roulette_from = kNoRoulette;

    bool operator==(const FrameSettings&) const = default;
};

// One stage at one bounce. The name is the row's kernel: generate, intersect, copy, sort, shade, compact,
// blend; or shade_<type>, a part of shade that ran in a stream of its own.
struct StageTime {
    const char* kernel;
    std::uint32_t bounce;
    std::uint32_t rays;
    double seconds;
    std::uint32_t dropped = 0;  // shade: samples to where nothing is reflected
    std::uint32_t clamped = 0;  // blend: samples that were no number, infinite or negative
    double start = -1.0;        // seconds after the frame's first kernel began; negative: not known
};

// What a bounce's rays hit, before they are shaded.
struct BounceView {
    std::uint32_t bounce;  // 0: camera rays
    RayColumns rays;
    HitColumns hits;
    const std::vector<std::uint32_t>& slots;  // of the active paths, in the order of the wavefront
    const std::uint32_t* excluded = nullptr;  // by slot, the primitive that the ray left out; null: none does
};
using BounceObserver = std::function<void(const BounceView&)>;

// One contender's pipeline on one backend.
class FramePipeline {
public:
    virtual ~FramePipeline() = default;
    // Traces sample number `sample` of every pixel and blends it into the image, which holds the samples
    // before it. `carry_t`: as in Intersector. The observer may be empty.
    virtual std::vector<StageTime> frame(bool carry_t, std::uint32_t sample, ImageStorage& image,
                                         const BounceObserver& observe) = 0;
};

}  // namespace ctpbench
