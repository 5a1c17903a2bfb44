// When the rounds of a contest end: not before `rounds` of them and `min_time` are done and the noise is low
// enough, unless `timeout` comes first. All times are of the rounds of one contest, that is of one workload's
// contenders together; loading, building and checking do not count.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

namespace ctpbench {

struct StopRule {
    std::uint32_t rounds = 1;
    double min_time = 0.0;  // seconds
    double max_noise =
        0.0;               // relative half-width of the widest interval among the contenders; 0: any will do
    double timeout = 0.0;  // seconds; 0: none

    // The share of what is known to be needed, for a progress line.
    double done(std::uint32_t round, double seconds) const {
        const double by_rounds = static_cast<double>(round) / rounds;
        return std::min({by_rounds, min_time > 0.0 ? seconds / min_time : 1.0, 1.0});
    }

    // Why there is no further round after `done` of them, one or more: "rounds", "min_time", "max_noise" (the
    // last demand that was met), "timeout" or "max_rounds". Empty: there is one. `noise` is asked for when
    // nothing else is missing.
    template <class Noise>
    std::string reason(std::uint32_t done, double seconds, std::uint32_t most, Noise&& noise) const {
        const bool enough = done >= rounds && seconds >= min_time;
        if (enough && (max_noise == 0.0 || noise() <= max_noise))
            return max_noise > 0.0 ? "max_noise" : min_time > 0.0 ? "min_time" : "rounds";
        if (timeout > 0.0 && seconds >= timeout) return "timeout";
        return done >= most ? "max_rounds" : "";
    }
};

}  // namespace ctpbench
