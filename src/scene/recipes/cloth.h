// Hanging cloth in regular folds that loosen towards the hem; the usual way to spend what is left of a
// recipe's triangles.
#pragma once

#include "scene/recipes/random.h"
#include "scene/recipes/surface.h"

namespace ctpbench::recipe {

struct Cloth {
    float width, height, depth;  // depth: of the folds, to either side of the frame's x-y plane
    int folds;
    float gather;  // how much narrower it is at `tie` (0: a plain curtain)
    float tie;     // height of the tie, as a share
};

// Hangs down from y = 0 of the frame to -height, from x = 0 to width; exactly `triangles`.
inline void hang_cloth(Mesh& mesh, const Frame& frame, const Cloth& cloth, std::size_t triangles,
                       MaterialId material, Random& random) {
    const float phase = random.unit(), sway = random.between(0.1f, 0.3f), ripple = random.unit();
    exact_surface(mesh, triangles, cloth.width * 2 / cloth.height, material, [&](float u, float v) {
        const float hang = 1 - v;  // v runs upward, as the winding wants
        const float fold = circle(static_cast<double>(cloth.folds) * u + phase + 0.1 * hang * sway).sin;
        const float fine = circle(2.7 * cloth.folds * u + ripple + 0.8 * hang).sin;
        const float swing = circle(static_cast<double>(u) + 1.3 * hang + phase).sin;
        const float from_tie = 1 - absolute(v - cloth.tie) / max(cloth.tie, 1 - cloth.tie);
        const float narrow = 1 - cloth.gather * from_tie * from_tie;
        return frame.point({cloth.width * (0.5f + (u - 0.5f) * narrow), -cloth.height * hang,
                            cloth.depth * (0.55f * fold + 0.2f * fine * hang + sway * swing * hang)});
    });
}

}  // namespace ctpbench::recipe
