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

template <class Methods, class Types = Primitives<Methods>>
using IntersectStrategies =
    TypeList<Ctp<Methods, Types>, StdVariant<Methods, Types>, Oop<Methods, Types>, OopArena<Methods, Types>,
             Restart<Methods, Types>, TypedLeaves<Methods, Types>>;

template <class Types>
using ShadeStrategies =
    TypeList<ShadeCtp<Types>, ShadeStdVariant<Types>, ShadeOop<Types>, ShadeOopArena<Types>, ShadeSort<Types>,
             ShadeSortRestored<Types>, ShadeQueues<Types>>;

// Whether shade kernels with the offset are compiled for every subset of the materials.
template <class Offset>
inline constexpr bool narrows_materials = std::is_same_v<Offset, Watertight::Offset>;

// Calls f(TypeTag<TypeList<...>>{}) with the list of materials that shade kernels are compiled for where a
// scene needs these: with the default offset the very list, one for every subset, with textures or without;
// with another one always all types.
template <class Offset, class F>
void visit_material_list(const MaterialTypes& types, F&& f) {
    if constexpr (narrows_materials<Offset>) {
        if (types.textured)
            visit_filtered<Materials>(types.mask, f);
        else
            visit_filtered<UntexturedMaterials>(types.mask, f);
    } else {
        if (types != MaterialTypes{}) trap();
        f(TypeTag<Materials>{});
    }
}

}  // namespace ctpbench
