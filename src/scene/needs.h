// Which types of primitives and materials occur in a scene: what kernels that are compiled for it need not
// ask about.
#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace ctpbench {

// What a scene's kernels must know of, read off the scene.
struct SceneNeeds {
    std::uint32_t primitives = 0;  // bit i: the type at position i of the list of primitives occurs
    std::uint32_t materials = 0;   // bit i: likewise of the list of materials
    bool textured = false;         // whether any material has a texture
    bool operator==(const SceneNeeds&) const = default;
};

// Of materials, those count that used_materials() names.
SceneNeeds needs_of(const Scene& scene);

}  // namespace ctpbench
