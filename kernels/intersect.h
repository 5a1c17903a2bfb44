// The intersect stage: one functor per pass over the active rays. A strategy supplies the traversal.
#pragma once

#include "methods/bundles.h"
#include "wavefront.h"

namespace ctpbench {

// What every pass reads and writes: `index[i]` is the slot of the i-th active ray.
struct IntersectBuffers {
    RayColumns rays;
    HitColumns hits;
    const std::uint32_t* index;
    std::uint32_t count;
    float extent;  // largest absolute coordinate of the scene's bounds
};

// What a later pass does with the hits of the one before.
enum class Pass {
    first,  // there are none
    carry,  // the closest t so far bounds the search
    merge,  // the search starts afresh, the nearer hit is kept
};

// Traversal: trivially copyable, with closest_hit(const RayContext<Methods>&, Hit&) const.
template <class Methods, class Traversal, Pass pass = Pass::first>
struct IntersectKernel {
    Traversal traversal;
    IntersectBuffers io;

    CTP_HD void operator()(std::uint32_t i) const {
        const std::uint32_t slot = io.index[i];
        const Ray ray = io.rays.load(slot);
        const RayContext<Methods> context(ray, io.extent);
        Hit hit = no_hit(ray);
        if constexpr (pass == Pass::carry) hit = io.hits.load(slot);
        traversal.closest_hit(context, hit);
        if constexpr (pass == Pass::merge) {
            const Hit before = io.hits.load(slot);
            if (before.primitive != kNoPrimitive && !before.accepts(hit.t, hit.primitive)) return;
        }
        io.hits.store(slot, hit);
    }
};

}  // namespace ctpbench
