#include "accel/scene_primitives.h"

#include "accel/sbvh_builder.h"

namespace ctpbench {

template Tree build_sbvh(const ScenePrimitives&, const SbvhSettings&, const BuildProgress&);

}  // namespace ctpbench
