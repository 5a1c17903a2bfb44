// An element as it lies in a GPU's memory: on a 16-byte boundary, so that a thread fetches it whole with a
// few 16-byte loads. A GPU pays for loads by their number, and lanes that read different elements pay for
// each load 32 times. The host needs none of this and pays for the padding, so it keeps plain arrays.
#pragma once

#include <cstdint>
#include <cstring>

#include "platform.h"

namespace ctpbench {

template <class T>
struct alignas(16) Slot {
    T value;
};

template <class T>
CTP_INLINE const T& fetch(const T& element) {
    return element;
}

// By value, into registers: whoever takes it must not index it by what only shows at run time.
template <class T>
CTP_INLINE T fetch(const Slot<T>& slot) {
#if defined(__CUDA_ARCH__)
    uint4 words[sizeof(Slot<T>) / 16];
    CTP_UNROLL
    for (unsigned i = 0; i < sizeof(Slot<T>) / 16; ++i)
        words[i] = __ldg(reinterpret_cast<const uint4*>(&slot) + i);
    T value;
    std::memcpy(&value, words, sizeof(T));
    return value;
#else
    return slot.value;
#endif
}

}  // namespace ctpbench
