// The colour of a Lambertian term: a texture that a constant tints; or the constant alone, for scenes without
// textures.
#pragma once

#include "description.h"
#include "scattering.h"

namespace ctpbench {

struct DiffuseColor {
    Vec3 factor;
    Texture texture;

    static DiffuseColor make(const MaterialDescription& d) { return {d.diffuse, d.texture}; }

    // Whether there is a surface at the point at all; if so, its albedo.
    CTP_INLINE bool at(const SurfacePoint& point, Vec3& albedo) const {
        albedo = factor;
        if (!texture.exists()) return true;
        const TextureSample s = sample_texture(point.attributes->texels, texture, point.texcoord());
        albedo = factor * s.color;
        return s.alpha >= 0.5f;
    }
};

struct ConstantColor {
    Vec3 factor;

    static ConstantColor make(const MaterialDescription& d) { return {d.diffuse}; }

    CTP_INLINE bool at(const SurfacePoint&, Vec3& albedo) const {
        albedo = factor;
        return true;
    }
};

}  // namespace ctpbench
