// What timings scatter by, seeded.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace ctpbench::test {

class Noise {
public:
    explicit Noise(std::uint64_t seed) : engine_(seed) {}
    // Between 0 and 1, never one of them.
    double uniform() { return (static_cast<double>(engine_() >> 11) + 0.5) * 0x1p-53; }
    // After Box and Muller, since the standard library's differs from one library to another.
    double normal() {
        const double radius = std::sqrt(-2.0 * std::log(uniform()));
        return radius * std::cos(6.283185307179586 * uniform());
    }
    // A factor that is 1 but for this share.
    double factor(double share) { return std::exp(share * normal()); }
    std::vector<double> rounds(std::size_t n, double level, double share) {
        std::vector<double> all(n);
        for (double& x : all) x = level * factor(share);
        return all;
    }

private:
    std::mt19937_64 engine_;
};

}  // namespace ctpbench::test
