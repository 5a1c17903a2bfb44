#include "wavefront/paths.h"

#include <algorithm>
#include <cmath>

#include "wavefront/compaction.h"

namespace ctpbench {
namespace {

float largest_coordinate(const Box& box) {
    if (box.is_empty()) return 0.0f;
    float extent = 0.0f;
    for (const Vec3& corner : {box.lo, box.hi})
        for (int axis = 0; axis < 3; ++axis) extent = std::max(extent, std::fabs(corner[axis]));
    return extent;
}

}  // namespace

SceneView::SceneView(const Scene& scene)
    : geometry_{scene.mesh.positions.data(),
                scene.mesh.triangles.data(),
                scene.spheres.data(),
                static_cast<std::uint32_t>(scene.mesh.triangles.size()),
                static_cast<std::uint32_t>(scene.spheres.size()),
                largest_coordinate(scene_bounds(scene))},
      material_(scene.mesh.material.data()),
      sphere_material_(scene.sphere_material) {
    for (const Material& m : scene.materials) albedo_.push_back(m.look.diffuse);
}

void trace_paths(CpuBackend& backend, const SceneView& scene, const Camera& camera,
                 const Intersector& intersector, const PathSettings& settings,
                 const BounceObserver& observe) {
    const std::uint32_t pixel_count = settings.width * settings.height;
    RayStorage rays;
    HitStorage hits;
    PixelStorage pixels;
    rays.resize(pixel_count), hits.resize(pixel_count), pixels.resize(pixel_count);
    std::vector<std::uint32_t> index(pixel_count), compacted(pixel_count);
    Compaction compaction;

    const CameraFrame frame = camera_frame(camera.eye, camera.target, camera.up, camera.fov_degrees,
                                           settings.width, settings.height);
    backend.for_each(pixel_count, GenerateKernel{frame, settings.width, settings.height, settings.seed, 0,
                                                 rays.view(), pixels.view(), index.data()});
    std::uint32_t active = pixel_count;
    for (std::uint32_t bounce = 0; bounce <= settings.bounces && active > 0; ++bounce) {
        observe(bounce, rays.view(), index.data(), active);
        intersector.intersect(
            backend, {rays.view(), hits.view(), index.data(), active, scene.geometry().extent}, true);
        backend.for_each(active, ShadeKernel{scene.geometry(), scene.materials(), rays.view(), hits.view(),
                                             pixels.view(), index.data(), settings.seed, 0, bounce, 1.0f});
        active = compaction.run(backend, hits.view(), index.data(), active, compacted.data());
        index.swap(compacted);
    }
}

}  // namespace ctpbench
