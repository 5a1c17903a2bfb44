// The wavefront's buffers on a device, shared by all pipelines of a workload. What a bounce counts (active
// paths, keys, samples dropped) has a place for each bounce: the host reads all of them once, after the
// frame.
#pragma once

#include <numeric>
#include <vector>

#include "kernels/tile.h"
#include "wavefront/device_columns.cuh"
#include "wavefront/device_place.cuh"
#include "wavefront/frame.h"
#include "wavefront/scene_view.h"

namespace ctpbench {

// What one bounce leaves for the host and for later stages.
struct BounceCounts {
    std::uint32_t active;                       // paths that are intersected
    std::uint32_t sorted[kShadeKeys + 1];       // where each key's paths begin, then their number
    std::uint32_t compacted[ByFate::keys + 1];  // likewise of fates
    std::uint32_t dropped;                      // of queues
    SegmentCounts queues;
};

struct DeviceWavefront {
    DeviceWavefront(const SceneView& scene, const FrameSettings& settings)
        : pixels(settings.width * settings.height),
          rays(pixels),
          hits(pixels),
          paths(pixels),
          image(pixels),
          index{DeviceArray<std::uint32_t>(pixels), DeviceArray<std::uint32_t>(pixels)},
          positions(pixels),
          copied(2 * std::size_t{pixels}),
          keys(pixels),
          fates(pixels),
          queue_slots(std::size_t{kShadeKeys} * pixels),
          tile_places(std::size_t{kShadeKeys} * (tile_count(pixels) + 1)),
          counts(settings.bounces + 2),
          host_counts(settings.bounces + 2) {
        std::vector<std::uint32_t> numbers(pixels);
        std::iota(numbers.begin(), numbers.end(), 0u);
        identity = DeviceArray<std::uint32_t>(numbers.data(), pixels);
        const GeometryView& g = scene.geometry();
        geometry = g;
        std::uint32_t positions = 0;
        for (std::uint32_t i = 0; i < g.triangle_count; ++i)
            for (const std::uint32_t v : g.triangles[i]) positions = v >= positions ? v + 1 : positions;
        geometry.positions = place(g.positions, positions);
        geometry.triangles = place(g.triangles, g.triangle_count);
        geometry.spheres = place(g.spheres, g.sphere_count);
        const SurfaceAttributes a = scene.attributes();
        attributes.texcoords = place(a.texcoords, scene.texcoord_count());
        attributes.texels = place(a.texels, scene.texel_count());
        words = scene.words();
        words.of_triangle = place(words.of_triangle, g.triangle_count);
    }

    std::uint32_t pixels;
    DevicePlace place;
    GeometryView geometry;
    SurfaceAttributes attributes;
    MaterialWords words;

    DeviceRays rays;
    DeviceHits hits;
    DevicePixels paths;
    DeviceImage image;
    DeviceArray<std::uint32_t> index[2];             // in turn
    DeviceArray<std::uint32_t> identity, positions;  // 0, 1, 2, ..., and the same sorted by key
    DeviceArray<std::uint32_t> excluded;             // by slot; empty until a pipeline needs it
    DeviceArray<std::uint32_t> copied;               // what the yardstick copies, and to where
    DeviceArray<std::uint8_t> keys, fates;
    DeviceArray<std::uint32_t> queue_slots;
    DeviceArray<std::uint32_t> tile_places;
    DeviceArray<BounceCounts> counts;
    std::vector<BounceCounts> host_counts;
};

}  // namespace ctpbench
