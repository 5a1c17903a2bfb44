// Random numbers by counter (Philox, Salmon et al., "Parallel Random Numbers: As Easy as 1, 2, 3", SC
// 2011): a number depends on what it is for, not on which thread draws it or when.
#pragma once

#include <Random123/philox.h>

#include "vec.h"

namespace ctpbench {

// What a draw is for; each purpose within a bounce has a dimension of its own.
enum class Dimension : std::uint32_t { camera = 0, direction = 1, survival = 2 };

struct Random4 {
    float v[4];  // each in [0, 1)
};

CTP_INLINE Random4 random4(std::uint64_t seed, std::uint32_t pixel, std::uint32_t sample,
                           std::uint32_t bounce, Dimension dimension) {
    const r123::Philox4x32::ctr_type counter = {
        {pixel, sample, bounce, static_cast<std::uint32_t>(dimension)}};
    const r123::Philox4x32::key_type key = {
        {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}};
    const r123::Philox4x32::ctr_type bits = r123::Philox4x32()(counter, key);
    Random4 r;
    CTP_UNROLL
    for (int i = 0; i < 4; ++i) r.v[i] = static_cast<float>(bits[i] >> 8) * 0x1p-24f;
    return r;
}

}  // namespace ctpbench
