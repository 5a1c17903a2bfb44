// The generate stage: one camera path per pixel, jittered within it.
#pragma once

#include "rng.h"
#include "wavefront.h"

namespace ctpbench {

// A pinhole camera resolved for an image size: direction = forward + x right + y up, x and y in [-1, 1].
struct CameraFrame {
    Vec3 eye, forward, right, up;
};

// `fov_degrees` spans the smaller image side.
inline CameraFrame camera_frame(Vec3 eye, Vec3 target, Vec3 up, float fov_degrees, std::uint32_t width,
                                std::uint32_t height) {
    const Vec3 forward = normalize(target - eye);
    const Vec3 right = normalize(cross(forward, up));
    const float half = std::tan(fov_degrees * (3.14159265358979f / 360.0f));
    const auto w = static_cast<float>(width), h = static_cast<float>(height);
    const float smaller = w < h ? w : h;
    return {eye, forward, right * (half * w / smaller), cross(right, forward) * (half * h / smaller)};
}

struct GenerateKernel {
    CameraFrame camera;
    std::uint32_t width, height;
    std::uint64_t seed;
    std::uint32_t sample;
    RayColumns rays;
    PixelColumns pixels;
    std::uint32_t* index;
    std::uint32_t* excluded = nullptr;  // by slot, what a ray leaves out: nothing; null: nobody asks

    CTP_INLINE void operator()(std::uint32_t i) const {
        const Random4 r = random4(seed, i, sample, 0, Dimension::camera);
        const float x = 2.0f * (static_cast<float>(i % width) + r.v[0]) / static_cast<float>(width) - 1.0f;
        const float y = 1.0f - 2.0f * (static_cast<float>(i / width) + r.v[1]) / static_cast<float>(height);
        const Vec3 d = normalize(camera.forward + x * camera.right + y * camera.up);
        rays.store(i, {camera.eye, d, std::numeric_limits<float>::infinity()});
        pixels.start(i);
        index[i] = i;
        if (excluded != nullptr) excluded[i] = kNoPrimitive;
    }
};

}  // namespace ctpbench
