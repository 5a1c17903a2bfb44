// The wavefront's buffers in a place's memory, shared by all pipelines of a workload. What a bounce counts
// (active paths, keys, samples dropped) has a place for each bounce: the host reads all of them once, after
// the frame.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "config/config.h"
#include "kernels/tile.h"
#include "wavefront/frame.h"
#include "wavefront/material_table.h"
#include "wavefront/placed_columns.h"
#include "wavefront/scene_view.h"

namespace ctpbench {

// What one bounce leaves for the host and for later stages.
struct BounceCounts {
    std::uint32_t active;                       // paths that are intersected
    std::uint32_t sorted[kMaxShadeKeys + 1];    // where each key's paths begin, then their number
    std::uint32_t compacted[ByFate::keys + 1];  // likewise of fates
    std::uint32_t dropped;                      // of queues
    std::uint32_t queues[kMaxShadeKeys];        // lengths, by key
};

struct PlacedWavefront {
    std::uint32_t pixels;
    GeometryView geometry;
    SurfaceAttributes attributes;

    RayColumns rays;
    HitColumns hits;
    PixelColumns paths;
    ImageColumns image;
    std::uint32_t* index[2];        // in turn
    const std::uint32_t* identity;  // 0, 1, 2, ...
    std::uint32_t* positions;       // the same sorted by key
    std::uint32_t* excluded;        // by slot, what paths leave out; null until a pipeline asks for it
    std::uint32_t* copied;          // what the yardstick copies, and to where
    std::uint8_t *keys, *fates;
    std::uint32_t* queue_slots;
    std::uint32_t* tile_places;
    BounceCounts* counts;
    std::vector<BounceCounts> host_counts;
};

// `keys`: the most shade keys that any pipeline tells apart.
template <class Place>
PlacedWavefront wavefront_in(const Place& place, const SceneView& scene, const FrameSettings& settings,
                             std::uint32_t keys) {
    PlacedWavefront w{};
    const std::uint32_t n = w.pixels = settings.width * settings.height;
    const auto numbers = [&](std::size_t count) { return place.template reserve<std::uint32_t>(count); };
    w.rays = rays_in(place, n), w.hits = hits_in(place, n);
    w.paths = pixels_in(place, n), w.image = image_in(place, n);
    w.index[0] = numbers(n), w.index[1] = numbers(n);
    w.positions = numbers(n), w.copied = numbers(2 * std::size_t{n});
    w.keys = place.template reserve<std::uint8_t>(n), w.fates = place.template reserve<std::uint8_t>(n);
    w.queue_slots = numbers(std::size_t{keys} * n);
    w.tile_places = numbers(std::size_t{std::max(keys, ByFate::keys)} * (tile_count(n) + 1));
    w.host_counts.resize(max_bounces + 2);  // pipelines may differ in their bounces
    w.counts = place.template reserve<BounceCounts>(w.host_counts.size());
    std::vector<std::uint32_t> identity(n);
    std::iota(identity.begin(), identity.end(), 0u);
    w.identity = place(identity.data(), n);

    const GeometryView& g = scene.geometry();
    w.geometry = g;
    std::uint32_t positions = 0;
    for (std::uint32_t i = 0; i < g.triangle_count; ++i)
        for (const std::uint32_t v : g.triangles[i]) positions = std::max(positions, v + 1);
    w.geometry.positions = place(g.positions, positions);
    w.geometry.triangles = place(g.triangles, g.triangle_count);
    w.geometry.spheres = place(g.spheres, g.sphere_count);
    const SurfaceAttributes a = scene.attributes();
    w.attributes.texcoords = place(a.texcoords, scene.texcoord_count());
    w.attributes.texels = place(a.texels, scene.texel_count());
    return w;
}

// The words of a table of materials in a place's memory.
template <class Place>
MaterialWords words_in(const Place& place, const MaterialTable& table) {
    MaterialWords words = table.words();
    words.of_triangle = place(words.of_triangle, words.triangle_count);
    return words;
}

// For pipelines whose paths leave out what they come from.
template <class Place>
void add_excluded(const Place& place, PlacedWavefront& w) {
    if (w.excluded == nullptr) w.excluded = place.template reserve<std::uint32_t>(w.pixels);
}

}  // namespace ctpbench
