// The extension point: the lists of contenders. Names, help texts and instantiations derive from them.
#pragma once

#include "dispatch/ctp.h"
#include "dispatch/oop.h"
#include "dispatch/oop_arena.h"
#include "dispatch/restart.h"
#include "dispatch/shade/ctp.h"
#include "dispatch/shade/oop.h"
#include "dispatch/shade/oop_arena.h"
#include "dispatch/shade/queues.h"
#include "dispatch/shade/sort.h"
#include "dispatch/shade/std_variant.h"
#include "dispatch/std_variant.h"
#include "dispatch/typed_leaves.h"

namespace ctpbench {

template <class Methods>
using IntersectStrategies = TypeList<Ctp<Methods>, StdVariant<Methods>, Oop<Methods>, OopArena<Methods>,
                                     Restart<Methods>, TypedLeaves<Methods>>;

using ShadeStrategies =
    TypeList<ShadeCtp, ShadeStdVariant, ShadeOop, ShadeOopArena, ShadeSort, ShadeSortRestored, ShadeQueues>;

}  // namespace ctpbench
