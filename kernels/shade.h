// The shade stage: what happens to a path where it hit something, or nothing. How the material's type is
// found is the strategy's (dispatch/shade/); everything else is here and the same for all.
#pragma once

#include "material_words.h"
#include "materials/scattering.h"
#include "roulette.h"
#include "surface.h"
#include "wavefront.h"

namespace ctpbench {

struct ShadeBuffers {
    GeometryView geometry;
    SurfaceAttributes attributes;
    MaterialWords words;
    RayColumns rays;
    HitColumns hits;
    PixelColumns pixels;
    const std::uint32_t* index;
    std::uint8_t* fates;  // by position: what became of the path
    std::uint64_t seed;
    std::uint32_t sample, bounce;
    Vec3 ambient;                               // radiance that arrives from outside, from every direction
    std::uint32_t roulette_from = kNoRoulette;  // the bounce from which on paths must survive roulette
    std::uint32_t* excluded = nullptr;          // by slot: what the path's next intersection leaves out; for
                                                // offsets that exclude, else not touched
};

// A path that left the scene gathers what is outside, and ends.
CTP_INLINE PathFate shade_miss(const ShadeBuffers& io, std::uint32_t slot) {
    io.pixels.add_radiance(slot, io.ambient);
    return PathFate::ended;
}

// The path goes on from the surface along the direction, on the side that the normal points to.
template <class Offset>
CTP_INLINE PathFate go_on(const ShadeBuffers& io, std::uint32_t slot, const Hit& hit, Vec3 point, Vec3 normal,
                          Vec3 direction) {
    constexpr float far = std::numeric_limits<float>::infinity();
    io.rays.store(slot, {Offset::origin(point, normal, direction, hit.t), direction, far});
    if constexpr (Offset::excludes) io.excluded[slot] = hit.primitive;
    return PathFate::goes_on;
}

// `sample(word, point, random)` asks the material that the word names for a Scattering.
template <class Offset, class Sample>
CTP_INLINE PathFate shade_hit(const ShadeBuffers& io, std::uint32_t slot, const Hit& hit, Sample&& sample) {
    const Ray ray = io.rays.load(slot);
    const Surface surface = surface_at(io.geometry, ray, hit);
    const SurfacePoint point{surface.normal, -ray.direction, &io.attributes, hit.primitive, hit.u, hit.v};
    const PathRandom random{io.seed, slot, io.sample, io.bounce};
    const Scattering s = sample(io.words.of(hit.primitive), point, random);
    if (s.event == ScatterEvent::scattered) {
        io.pixels.scale_throughput(slot, s.weight);
        if (io.bounce >= io.roulette_from && !survives(io.pixels, slot, random)) return PathFate::ended;
        return go_on<Offset>(io, slot, hit, surface.point, surface.normal, s.direction);
    }
    if (s.event == ScatterEvent::passed)
        return go_on<Offset>(io, slot, hit, surface.point, -surface.normal, ray.direction);
    if (s.event == ScatterEvent::dropped) return PathFate::dropped;
    io.pixels.add_radiance(slot, s.emitted);
    return PathFate::ended;
}

// One kernel for paths of any kind. Table: trivially copyable, with sample(word, point, random) const.
template <class Table, class Offset>
struct ShadeAnyKernel {
    Table table;
    ShadeBuffers io;

    CTP_INLINE void operator()(std::uint32_t i) const {
        const std::uint32_t slot = io.index[i];
        const Hit hit = io.hits.load(slot);
        const PathFate fate = hit.primitive == kNoPrimitive
                                  ? shade_miss(io, slot)
                                  : shade_hit<Offset>(io, slot, hit,
                                                      [&](MaterialWord word, const SurfacePoint& point,
                                                          const PathRandom& random) {
                                                          return table.sample(word, point, random);
                                                      });
        io.fates[i] = static_cast<std::uint8_t>(fate);
    }
};

// The materials of one type, by their number.
template <class T>
struct TypedMaterials {
    const T* elements;
    std::uint32_t first;  // number of the first

    template <class Offset>
    CTP_INLINE PathFate shade(const ShadeBuffers& io, std::uint32_t slot) const {
        return shade_hit<Offset>(io, slot, io.hits.load(slot),
                                 [&](MaterialWord word, const SurfacePoint& point, const PathRandom& random) {
                                     return elements[word.number() - first].sample(point, random);
                                 });
    }
};

}  // namespace ctpbench
