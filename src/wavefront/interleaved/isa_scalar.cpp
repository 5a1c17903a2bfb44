#include "wavefront/interleaved/code_impl.h"

namespace ctpbench {

template struct InterleavedCode<ScalarIsa>;

}  // namespace ctpbench
