// Compiled with the flags of this instruction set (CMakeLists.txt).
#if defined(__x86_64__)
#include "wavefront/interleaved/code_impl.h"

namespace ctpbench {

template struct InterleavedCode<Avx512>;

}  // namespace ctpbench
#endif
