// Every CUDA call goes through check_cuda(), every launch is followed by check_launch(): a failure that is
// ignored shows up later, elsewhere, as a wrong figure.
#pragma once

#include <cuda_runtime.h>

#include <string>

#include "base/error.h"

namespace ctpbench {

// `what` says what was being done.
inline void check_cuda(cudaError_t status, const char* what, const char* file = __builtin_FILE(),
                       int line = __builtin_LINE()) {
    if (status == cudaSuccess) return;
    cudaGetLastError();  // so that an error which can be recovered from is not reported twice
    throw Error(ExitCode::internal, std::string("CUDA: error: ") + cudaGetErrorName(status) + " (" +
                                        cudaGetErrorString(status) + ") while " + what + ", at " + file +
                                        ":" + std::to_string(line) +
                                        "; compute-sanitizer tells more, --backend cpu does without");
}

inline void check_launch(const char* kernel, const char* file = __builtin_FILE(),
                         int line = __builtin_LINE()) {
    check_cuda(cudaGetLastError(), kernel, file, line);
}

}  // namespace ctpbench
