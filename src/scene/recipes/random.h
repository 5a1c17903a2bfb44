// Random numbers for the recipes: Philox keyed by (seed, stream), with its own mapping to floats, because
// the standard distributions differ between libraries and a stand-in must be the same mesh everywhere.
#pragma once

#include <Random123/philox.h>

#include <cstdint>

#include "kernels/vec.h"

namespace ctpbench::recipe {

// One draw per call or expression: the order in which a compiler evaluates a function's arguments, or the two
// sides of an operator, is its own affair. Braces and declarations keep theirs.
class Random {
public:
    Random(std::uint64_t seed, std::uint32_t stream)
        : key_{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}},
          counter_{{0, 0, stream, 0}} {}

    std::uint32_t bits() {
        if (used_ == 4) {
            block_ = r123::Philox4x32{}(counter_, key_);
            if (++counter_[0] == 0) ++counter_[1];
            used_ = 0;
        }
        return block_[used_++];
    }

    // In [0, 1): 24 bits, so every value is exact.
    float unit() { return static_cast<float>(bits() >> 8) * (1.0f / 16777216.0f); }
    float between(float low, float high) { return low + (high - low) * unit(); }
    // In [0, n), by multiplication; the bias of at most n / 2^32 is of no account here.
    std::uint32_t below(std::uint32_t n) {
        return static_cast<std::uint32_t>((static_cast<std::uint64_t>(bits()) * n) >> 32);
    }
    // Bell-shaped, within +-1 and with a standard deviation of 1/3.
    float bell() {
        const float a = unit(), b = unit(), c = unit();
        return (a + b + c) * (2.0f / 3.0f) - 1.0f;
    }
    // Uniform on the unit sphere, by rejection: no transcendental functions.
    Vec3 direction() {
        for (;;) {
            const float x = between(-1, 1), y = between(-1, 1), z = between(-1, 1);
            const float squared = x * x + y * y + z * z;
            if (squared > 0.01f && squared <= 1.0f) return normalize(Vec3{x, y, z});
        }
    }

private:
    r123::Philox4x32::key_type key_;
    r123::Philox4x32::ctr_type counter_;
    r123::Philox4x32::ctr_type block_{};
    int used_ = 4;
};

}  // namespace ctpbench::recipe
