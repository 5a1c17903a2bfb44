// What a material is asked about a point on a surface, and what it answers.
#pragma once

#include <array>

#include "../rng.h"
#include "../texture.h"

namespace ctpbench {

// Attributes of surfaces that only some materials look at.
struct SurfaceAttributes {
    const std::array<Vec2, 3>* texcoords;  // of each triangle's vertices; null if the scene has no textures
    const Texel* texels;
};

// A point on a surface. Directions point away from it; all are of unit length.
struct SurfacePoint {
    Vec3 normal;  // geometric, on the side that the path came from
    Vec3 wo;      // to where the path came from
    const SurfaceAttributes* attributes;
    std::uint32_t primitive;
    float u, v;  // barycentric weights of the second and third vertex

    // Spheres have none: their material must not be textured.
    CTP_INLINE Vec2 texcoord() const {
        const std::array<Vec2, 3>& t = attributes->texcoords[primitive];
        const float w = 1.0f - u - v;
        return {w * t[0].x + u * t[1].x + v * t[2].x, w * t[0].y + u * t[1].y + v * t[2].y};
    }
};

// The random numbers of one path at one bounce, drawn when a material wants them.
struct PathRandom {
    std::uint64_t seed;
    std::uint32_t pixel, sample, bounce;

    CTP_INLINE Random4 draw() const { return random4(seed, pixel, sample, bounce, Dimension::direction); }
    // What decides whether the path survives: of its own, so that directions are the same with and without.
    CTP_INLINE float draw_survival() const {
        return random4(seed, pixel, sample, bounce, Dimension::survival).v[0];
    }
};

enum class ScatterEvent : std::uint32_t {
    scattered,  // the path goes on along `direction`
    passed,     // there is no surface here: the path goes on as it came
    absorbed,   // it ends here, with what `emitted` says
    dropped,    // the direction sampled is on the wrong side of the surface: its weight is 0
};

struct Scattering {
    ScatterEvent event;
    Vec3 direction;
    Vec3 weight;   // f cos / density of the direction: what the path's throughput is multiplied by
    Vec3 emitted;  // radiance towards wo
};

CTP_INLINE Scattering scattered(Vec3 direction, Vec3 weight) {
    return {ScatterEvent::scattered, direction, weight, {0.0f, 0.0f, 0.0f}};
}
CTP_INLINE Scattering without_light(ScatterEvent event) {
    return {event, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}};
}

inline constexpr float kInvPi = 0.318309886183791f;

}  // namespace ctpbench
