// Diffuse textures. The texels of all textures of a scene lie in one arena, so that one pointer serves every
// material on either side of a bus. They are linear with 16 bits a channel: that holds what 8-bit sRGB holds,
// and needs no table to decode.
#pragma once

#include <cmath>
#include <cstdint>

#include "vec.h"

namespace ctpbench {

struct Vec2 {
    float x, y;
};

// Linear RGB and coverage; 65535 stands for 1.
struct Texel {
    std::uint16_t r, g, b, a;
};

// Where a texture's texels are in the arena: rows of `width`, from the bottom (v = 0) up. All zero: no
// texture.
struct Texture {
    std::uint32_t first;
    std::uint16_t width, height;

    CTP_INLINE bool exists() const { return width != 0; }
};

struct TextureSample {
    Vec3 color;
    float alpha;
};

// Bilinear, repeated in both directions; texel centres are at half-integers. The coordinates must be finite.
CTP_INLINE TextureSample sample_texture(const Texel* arena, const Texture& texture, Vec2 uv) {
    const auto axis = [](float t, std::uint32_t size, std::uint32_t& i0, std::uint32_t& i1) {
        const float x = (t - std::floor(t)) * static_cast<float>(size) - 0.5f;  // in [-1/2, size - 1/2]
        const float below = std::floor(x);
        const auto i = static_cast<std::int32_t>(below);
        i0 = i < 0 ? size - 1 : static_cast<std::uint32_t>(i);
        i1 = static_cast<std::uint32_t>(i + 1) == size ? 0 : static_cast<std::uint32_t>(i + 1);
        return x - below;
    };
    std::uint32_t x0, x1, y0, y1;
    const float fx = axis(uv.x, texture.width, x0, x1), fy = axis(uv.y, texture.height, y0, y1);
    const Texel* row0 = arena + texture.first + y0 * texture.width;
    const Texel* row1 = arena + texture.first + y1 * texture.width;
    // No arrays: a GPU would keep them in local memory.
    const Texel t0 = row0[x0], t1 = row0[x1], t2 = row1[x0], t3 = row1[x1];
    float r = 0.0f, g = 0.0f, b = 0.0f, a = 0.0f;
    const auto add = [&](const Texel& t, float w) {
        r += w * static_cast<float>(t.r);
        g += w * static_cast<float>(t.g);
        b += w * static_cast<float>(t.b);
        a += w * static_cast<float>(t.a);
    };
    add(t0, (1.0f - fx) * (1.0f - fy)), add(t1, fx * (1.0f - fy));
    add(t2, (1.0f - fx) * fy), add(t3, fx * fy);
    constexpr float unit = 1.0f / 65535.0f;
    return {{r * unit, g * unit, b * unit}, a * unit};
}

}  // namespace ctpbench
