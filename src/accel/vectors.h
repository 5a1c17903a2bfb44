// Vectors of four and eight numbers: GCC's and Clang's vector extension, which both compile to whatever the
// target has.
#pragma once

#include <cstdint>

namespace ctpbench {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));
using Float8 = float __attribute__((vector_size(32)));
using Int8 = std::int32_t __attribute__((vector_size(32)));

// One instruction each. If either argument is NaN, the result is the second.
inline Float4 lower(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 upper(Float4 a, Float4 b) { return a > b ? a : b; }

}  // namespace ctpbench
