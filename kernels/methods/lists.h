// The lists of methods, one per kind, the default first. Names, help and instantiations derive from them.
#pragma once

#include "../type_list.h"
#include "box_ize.h"
#include "box_padded.h"
#include "box_plain.h"
#include "offset_constant_epsilon.h"
#include "offset_exclude_id.h"
#include "offset_relative_epsilon.h"
#include "offset_waechter_binder.h"
#include "sphere_stable.h"
#include "sphere_stable_f64.h"
#include "sphere_textbook.h"
#include "triangle_baldwin_weber.h"
#include "triangle_moeller_trumbore.h"
#include "triangle_moeller_trumbore_f64.h"
#include "triangle_pluecker.h"
#include "triangle_watertight.h"

namespace ctpbench {

using TriangleTests =
    TypeList<WatertightTriangle, MoellerTrumbore, Pluecker, BaldwinWeber, MoellerTrumbore64>;
using SphereTests = TypeList<StableSphere, TextbookSphere, StableSphere64>;
using BoxTests = TypeList<PaddedBox, PlainBox, IzeBox>;
using Offsets = TypeList<WaechterBinder, ConstantEpsilon, RelativeEpsilon, ExcludeId>;

}  // namespace ctpbench
