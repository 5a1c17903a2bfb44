// The list of primitive types. A type's position is its tag in trees and variants.
#pragma once

#include "sphere.h"
#include "triangle.h"

namespace ctpbench {

template <class Methods>
using Primitives = TypeList<Triangle<Methods>, Sphere<Methods>>;

}  // namespace ctpbench
