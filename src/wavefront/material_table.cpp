#include "wavefront/material_table.h"

namespace ctpbench {

MaterialTable::MaterialTable(const Scene& scene, const MaterialTypes& types) : known_(types) {
    std::vector<MaterialWord> word_of(scene.materials.size());
    first_.push_back(0);
    for (std::uint32_t type = 0, position = 0; type < Materials::size; ++type) {
        if ((types.mask >> type & 1u) == 0) continue;
        for (std::size_t m = 0; m < scene.materials.size(); ++m) {
            if (scene.materials[m].look.type != type) continue;
            word_of[m] = MaterialWord::make(position, static_cast<std::uint32_t>(descriptions_.size()));
            descriptions_.push_back(scene.materials[m].look);
        }
        first_.push_back(static_cast<std::uint32_t>(descriptions_.size()));
        ++position;
    }
    words_.reserve(scene.mesh.material.size());
    for (const std::uint32_t m : scene.mesh.material) words_.push_back(word_of[m]);
    of_spheres_ = word_of[scene.sphere_material];
}

MaterialTable::MaterialTable(const Scene& scene, const TypeChoice& choice) : synthetic_(choice.synthetic) {
    std::vector<MaterialWord> word_of(kSyntheticMaterials);
    first_.push_back(0);
    for (std::uint32_t type = 0; type < synthetic_.listed; ++type) {
        for (std::uint32_t m = 0; m < kSyntheticMaterials; ++m) {
            if (synthetic_type(choice, m) != type) continue;
            word_of[m] = MaterialWord::make(type, static_cast<std::uint32_t>(descriptions_.size()));
            MaterialDescription& look = descriptions_.emplace_back();
            const float albedo = 0.3f + 0.5f * static_cast<float>(m) / kSyntheticMaterials;
            look.diffuse = {albedo, albedo, albedo};
        }
        first_.push_back(static_cast<std::uint32_t>(descriptions_.size()));
    }
    words_.reserve(scene.mesh.triangles.size());
    for (std::uint32_t i = 0; i < scene.mesh.triangles.size(); ++i)
        words_.push_back(word_of[synthetic_material(i)]);
}

}  // namespace ctpbench
