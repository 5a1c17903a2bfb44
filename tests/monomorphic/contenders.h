// The hand-written kernels and the strategies that are held against them, by name. What they are made with is
// decided here and nowhere else.
#pragma once

#include <memory>
#include <string>

#include "wavefront/forest.h"
#include "wavefront/intersector.h"
#include "wavefront/scene_view.h"
#include "wavefront/shader.h"

namespace ctpbench::monomorphic {

inline constexpr const char* kByHand = "by_hand";

// A scene of matte triangles (matte_scene.h) with the trees of every strategy. The scene must outlive it.
struct Stage {
    Stage(const Scene& scene, int threads, const std::set<TreeKind>& kinds);

    const Scene& scene;
    SceneView view;
    CpuBackend backend;
    Forest forest;
    MaterialTable materials;  // of the types that the scene has
};

// kByHand or a strategy's name, which throws if there is none. The stage must outlive what is made.
std::unique_ptr<Intersector> intersector_of(const Stage& stage, const std::string& name);
std::unique_ptr<Shader> shader_of(const Stage& stage, const std::string& name);

// The trees that these intersectors need.
std::set<TreeKind> trees_of(const std::vector<std::string>& names);

}  // namespace ctpbench::monomorphic
