// The materials of a scene as one contender's kernels know them: numbered by type, and each triangle's word.
// Types are counted among those that the contender is compiled for. Refers to the scene, which must outlive
// it.
#pragma once

#include <cstdint>
#include <vector>

#include "kernels/array.h"
#include "kernels/dispatch/shade/layout.h"
#include "scene/scene.h"
#include "wavefront/type_choice.h"

namespace ctpbench {

class MaterialTable {
public:
    // Compiled for these types, among which are all that triangles and spheres of the scene have.
    MaterialTable(const Scene& scene, const MaterialTypes& types);
    // Synthetic materials (type_choice.h) in place of the scene's, which has no spheres.
    MaterialTable(const Scene& scene, const TypeChoice& choice);

    MaterialWords words() const {
        return {words_.data(), static_cast<std::uint32_t>(words_.size()), of_spheres_, types()};
    }
    MaterialInput input() const { return {descriptions_.data(), first_.data(), known_, synthetic_}; }
    std::uint32_t types() const { return static_cast<std::uint32_t>(first_.size() - 1); }

private:
    std::vector<MaterialDescription> descriptions_;  // grouped by type
    std::vector<std::uint32_t> first_;               // of each type, and where the last one ends
    MaterialTypes known_{};
    SyntheticTypes synthetic_{};
    Array<MaterialWord> words_;  // of each triangle
    MaterialWord of_spheres_{};
};

}  // namespace ctpbench
