// Instruction sets that kernels over packs are compiled for, each in source files of its own with the
// compiler's flags for it. Every function of such a file is a template over one of these tags or forced
// inline: a plain inline function would be compiled once per set under one name, and the linker may keep one
// that this machine cannot run.
#pragma once

#include "../type_list.h"

namespace ctpbench {

struct Avx512 {
    static constexpr const char* name = "avx512";
};
struct Avx2 {
    static constexpr const char* name = "avx2";
};
struct ScalarIsa {
    static constexpr const char* name = "scalar";
};

// The widest first.
using Isas = TypeList<Avx512, Avx2, ScalarIsa>;

}  // namespace ctpbench
