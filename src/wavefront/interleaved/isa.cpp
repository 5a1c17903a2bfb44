#include "wavefront/interleaved/isa.h"

namespace ctpbench {

std::vector<std::string> usable_isas() {
    std::vector<std::string> usable;
#if defined(__x86_64__)
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
        usable.push_back(Avx512::name);
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2"))
        usable.push_back(Avx2::name);
#endif
    usable.push_back(ScalarIsa::name);
    return usable;
}

}  // namespace ctpbench
