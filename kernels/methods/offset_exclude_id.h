// A secondary ray starts at the point itself, and the next intersection leaves out the primitive that the
// point is on: the path remembers its id. Exact for a flat primitive, which no ray can meet again. It says
// nothing of the neighbours, which share the point's rounding where it lies near an edge; and a sphere can be
// hit again, from inside, so there it is wrong.
//
// The intersect stage must do its part: methods whose `excludes` is true (methods/bundles.h).
#pragma once

#include "../vec.h"

namespace ctpbench {

struct ExcludeId {
    static constexpr const char* name = "exclude_id";
    static constexpr bool excludes = true;

    // As WaechterBinder::origin().
    CTP_INLINE static Vec3 origin(Vec3 point, Vec3 /*normal*/, Vec3 /*direction*/, float /*t*/) {
        return point;
    }
};

}  // namespace ctpbench
