// What differs between a host compiler and nvcc, and nothing else.
#pragma once

#if defined(__CUDACC__)
#define CTP_HD __host__ __device__
#else
#define CTP_HD
#endif

#define CTP_INLINE CTP_HD inline __attribute__((always_inline))

namespace ctpbench {

// Ends the program at once. For states that no input can reach, such as a type tag outside its type
// list: returning a default there would hide a wrong hit inside a plausible image.
[[noreturn]] CTP_HD inline void trap() {
#if defined(__CUDA_ARCH__)
    __trap();
    while (true) {
    }
#else
    __builtin_trap();
#endif
}

}  // namespace ctpbench
