// Russian roulette (Arvo & Kirk, "Particle Transport and Image Synthesis", SIGGRAPH 1990): a path that
// carries little is ended at random, and those that survive stand for it. The mean stays what it was; the
// variance grows, and the time per path shrinks.
#pragma once

#include "materials/scattering.h"
#include "wavefront.h"

namespace ctpbench {

inline constexpr std::uint32_t kNoRoulette = 0xffffffffu;  // a bounce that no path reaches

// Whether the path goes on, which it does with the probability of the largest component of its throughput,
// but no more than 0.95: else paths without loss would never end. If it does, its throughput is divided by
// that.
CTP_INLINE bool survives(const PixelColumns& paths, std::uint32_t slot, const PathRandom& random) {
    constexpr float most = 0.95f;
    const Vec3 throughput = paths.throughput(slot);
    const float largest = max(max(throughput.x, throughput.y), throughput.z);
    const float probability = largest > most ? most : largest;
    if (random.draw_survival() >= probability) return false;
    const float weight = 1.0f / probability;
    paths.scale_throughput(slot, {weight, weight, weight});
    return true;
}

}  // namespace ctpbench
