// Embree as the reference for hits and as the yardstick of throughput: triangles and sphere points, built
// at high quality, traced one ray at a time from the same columns as our own contenders.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "wavefront/intersector.h"

namespace ctpbench {

enum class EmbreeMode { robust, fast };  // RTC_SCENE_FLAG_ROBUST, or Embree's default flags

struct EmbreeContender {
    std::string name;
    EmbreeMode mode;
};
// The yardstick contenders that configs may name.
std::vector<EmbreeContender> embree_contenders();

// "3.13.5", or empty if this program was built without Embree.
std::string embree_version();

class EmbreeIntersector : public Intersector {
public:
    double build_seconds() const { return build_seconds_; }

protected:
    double build_seconds_ = 0.0;
};

// Builds Embree's own tree of the scene with this many threads. Throws Error(no_backend) without Embree.
std::unique_ptr<EmbreeIntersector> make_embree(const Scene& scene, EmbreeMode mode, int threads);

}  // namespace ctpbench
