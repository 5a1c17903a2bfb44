// What a scene takes, column by column. Kernels read each as it stands, but for the descriptions of
// materials, which strategies make their own objects of.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace ctpbench {

struct SceneColumn {
    std::string name;
    std::size_t bytes;  // of its elements, without what is reserved for more
};

// All columns, be they empty or not.
std::vector<SceneColumn> columns_of(const Scene& scene);

}  // namespace ctpbench
