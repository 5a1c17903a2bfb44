// A scene in Embree: its device, its geometries, its tree. Whatever differs only in how it is traced shares
// it.
#pragma once

#include <atomic>
#include <cstdint>

#include "scene/scene.h"

struct RTCDeviceTy;
struct RTCSceneTy;

namespace ctpbench {

enum class EmbreeMode { robust, fast };  // RTC_SCENE_FLAG_ROBUST, or Embree's default flags

// Geometry 0 holds the triangles, geometry 1 the spheres; either may be absent.
class EmbreeScene {
public:
    // Builds at high quality with this many threads. Throws Error(no_backend) without Embree.
    EmbreeScene(const Scene& scene, EmbreeMode mode, int threads);
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    RTCSceneTy* handle() const { return scene_; }
    std::uint32_t first_sphere() const { return first_sphere_; }
    double build_seconds() const { return build_seconds_; }
    std::size_t bytes() const { return static_cast<std::size_t>(bytes_.load()); }

private:
    RTCDeviceTy* device_ = nullptr;
    RTCSceneTy* scene_ = nullptr;
    std::uint32_t first_sphere_ = 0;
    double build_seconds_ = 0.0;
    std::atomic<std::ptrdiff_t> bytes_{0};
};

}  // namespace ctpbench
