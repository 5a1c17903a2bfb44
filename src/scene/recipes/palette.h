// How recipes name the materials that their triangles get.
#pragma once

#include <string>
#include <vector>

#include "kernels/materials/list.h"
#include "scene/scene.h"

namespace ctpbench::recipe {

using MaterialId = std::uint32_t;

inline MaterialId add_material(std::vector<Material>& materials, std::string name,
                               const MaterialDescription& look) {
    materials.push_back({std::move(name), look});
    return static_cast<MaterialId>(materials.size() - 1);
}

inline MaterialId add_matte(std::vector<Material>& materials, std::string name, Vec3 diffuse) {
    return add_material(materials, std::move(name), {.diffuse = diffuse, .type = material_type<Matte>});
}

// The gloss is grey: light that a varnish reflects does not take its colour.
inline MaterialId add_plastic(std::vector<Material>& materials, std::string name, Vec3 diffuse,
                              float specular, float exponent) {
    return add_material(materials, std::move(name),
                        {.diffuse = diffuse,
                         .specular = {specular, specular, specular},
                         .exponent = exponent,
                         .type = material_type<Plastic>});
}

inline MaterialId add_mirror(std::vector<Material>& materials, std::string name, Vec3 specular) {
    return add_material(materials, std::move(name), {.specular = specular, .type = material_type<Mirror>});
}

inline MaterialId add_emissive(std::vector<Material>& materials, std::string name, Vec3 emission) {
    return add_material(materials, std::move(name), {.emission = emission, .type = material_type<Emissive>});
}

}  // namespace ctpbench::recipe
