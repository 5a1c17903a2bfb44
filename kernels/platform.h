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
