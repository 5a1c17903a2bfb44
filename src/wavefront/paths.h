// The bounce loop of the paper's Figure 2, for matte surfaces: generate, then intersect, shade and
// compact once per bounce.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "backends/cpu.h"
#include "kernels/generate.h"
#include "kernels/shade.h"
#include "scene/scene.h"
#include "wavefront/columns.h"
#include "wavefront/intersector.h"

namespace ctpbench {

// A scene's geometry and materials as kernels see them. Refers to the scene, which must outlive it.
class SceneView {
public:
    explicit SceneView(const Scene& scene);
    const GeometryView& geometry() const { return geometry_; }
    MaterialView materials() const { return {albedo_.data(), material_, sphere_material_}; }

private:
    GeometryView geometry_;
    std::vector<Vec3> albedo_;
    const std::uint32_t* material_;
    std::uint32_t sphere_material_;
};

struct PathSettings {
    std::uint32_t width, height;
    std::uint32_t bounces;  // intersections after the camera ray's
    std::uint64_t seed;
};

// Called before each intersection with the bounce (0 for camera rays), the rays, and the active indices.
using BounceObserver = std::function<void(std::uint32_t bounce, RayColumns rays, const std::uint32_t* index,
                                          std::uint32_t active)>;

// Traces one sample of every pixel's path.
void trace_paths(CpuBackend& backend, const SceneView& scene, const Camera& camera,
                 const Intersector& intersector, const PathSettings& settings, const BounceObserver& observe);

}  // namespace ctpbench
