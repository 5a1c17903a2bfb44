// What differs between compilers and systems, and nothing else.
#pragma once

#include <cstddef>

#if defined(__linux__)
#include <sys/mman.h>
#endif

#if defined(__CUDACC__)
#define CTP_HD __host__ __device__
#else
#define CTP_HD
#endif

#define CTP_INLINE CTP_HD inline __attribute__((always_inline))

// Before a loop over a small array: unrolled, so that a GPU keeps the array in registers.
#if defined(__CUDA_ARCH__)
#define CTP_UNROLL _Pragma("unroll")
#else
#define CTP_UNROLL
#endif

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

// p[i] for an i that only shows at run time. A processor computes the address. A GPU
// selects from registers: an array that is indexed so would be moved to local memory, and loads of single
// words cost it as much as loads of four.
CTP_INLINE float element(const float (&p)[3], int i) {
#if defined(__CUDA_ARCH__)
    const float a = p[0], b = p[1], c = p[2];
    return i == 0 ? a : i == 1 ? b : c;
#else
    return p[i];
#endif
}

// Starts fetching a cache line. Any address will do.
CTP_INLINE void prefetch([[maybe_unused]] const void* p) {
#if !defined(__CUDA_ARCH__)
    __builtin_prefetch(p);
#endif
}

inline constexpr std::size_t kHugePage = std::size_t{2} << 20;

// Asks for huge pages, which is a hint: the memory works either way.
inline void advise_huge_pages([[maybe_unused]] void* p, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
    madvise(p, bytes, MADV_HUGEPAGE);
#endif
}

}  // namespace ctpbench
