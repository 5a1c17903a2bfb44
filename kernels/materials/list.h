// The list of material types. A type's position is its tag in variants and in sort keys, and its name is what
// scene files call it.
#pragma once

#include "../type_list.h"
#include "emissive.h"
#include "matte.h"
#include "mirror.h"
#include "plastic.h"

namespace ctpbench {

using Materials = TypeList<Matte, Plastic, Mirror, Emissive>;

template <class T>
inline constexpr std::uint32_t material_type = static_cast<std::uint32_t>(index_of<T, Materials>);

}  // namespace ctpbench
