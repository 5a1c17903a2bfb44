// Small frames for tests: a scene with its tree and what traces it, and one call that renders.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "wavefront/batch.h"
#include "wavefront/forest.h"
#include "wavefront/renderer.h"
#include "wavefront/typed_scenes.h"

namespace ctpbench::test {

// The scene must outlive it.
struct Stage {
    Stage(const Scene& scene, int threads, const std::string& strategy = "ctp",
          const std::string& methods = Watertight::name, const std::string& types = kAllTypes)
        : view(scene),
          backend(threads),
          forest(build_forest(backend, scene, trees(), SbvhSettings::quality(), nullptr,
                              [](const std::string&, double) {})),
          scenes(backend, scene, view, forest, trees(), SbvhSettings::quality()),
          intersector(make_intersector(strategy, methods, scenes.layout(types))),
          materials(scenes.materials(types, WaechterBinder::name)) {}

    static std::set<TreeKind> trees() {
        return {TreeKind::mixed, TreeKind::typed_leaves, TreeKind::per_type};
    }

    SceneView view;
    CpuBackend backend;
    Forest forest;
    TypedScenes scenes;
    std::unique_ptr<Intersector> intersector;
    const MaterialTable& materials;  // for the default offset; with all types, for any
};

struct Frames {
    ImageStorage image;
    std::vector<StageTime> stages;  // of all frames
};

inline Frames render(Stage& stage, const Camera& camera, const FrameSettings& settings,
                     std::uint32_t samples = 1, const std::string& shade = "ctp",
                     const BounceObserver& observe = {}, const std::string& offset = WaechterBinder::name) {
    Frames frames;
    const auto shader = make_shader(shade, stage.materials, offset);
    Renderer renderer(stage.backend, stage.view, camera, settings);
    for (std::uint32_t s = 0; s < samples; ++s) {
        const auto stages = renderer.frame(*stage.intersector, *shader, true, s, frames.image, observe);
        frames.stages.insert(frames.stages.end(), stages.begin(), stages.end());
    }
    return frames;
}

inline Camera looking_from(Vec3 eye, Vec3 target) {
    Camera camera;
    camera.eye = eye, camera.target = target;
    return camera;
}

}  // namespace ctpbench::test
