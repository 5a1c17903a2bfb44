// Which instruction sets kernels over packs are compiled for, and which of them this machine can run.
#pragma once

#include <string>
#include <vector>

#include "kernels/simd/isa.h"

namespace ctpbench {

// By name, the best first; those that this program was compiled for and that this machine can run.
std::vector<std::string> usable_isas();

// Calls f(TypeTag<Isa>{}) for the one of this name, which must be among them.
#if defined(__x86_64__)
using CompiledIsas = Isas;
#else
using CompiledIsas = TypeList<ScalarIsa>;
#endif
template <class F>
void visit_isa(const std::string& name, F&& f) {
    for_each_type(CompiledIsas{}, [&](auto tag) {
        if (name == decltype(tag)::type::name) f(tag);
    });
}

}  // namespace ctpbench
