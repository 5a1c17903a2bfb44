// A material as the scene stores it, before a strategy makes an object of its type of it. All colours are
// linear RGB. What a type does not name it does not use.
#pragma once

#include "../texture.h"

namespace ctpbench {

struct MaterialDescription {
    Vec3 diffuse{0.5f, 0.5f, 0.5f};   // albedo in [0, 1]; multiplies the texture if there is one
    Vec3 specular{0.0f, 0.0f, 0.0f};  // reflectance in [0, 1]
    float exponent = 0.0f;            // of the glossy lobe (MTL's Ns), >= 0
    Vec3 emission{0.0f, 0.0f, 0.0f};  // radiance, scene units
    Texture texture{};                // diffuse; where its alpha is below one half there is no surface
    std::uint32_t type = 0;           // position in the list of materials (materials/list.h)
};

}  // namespace ctpbench
