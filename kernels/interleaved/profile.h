// Where the time of rays in flight goes, phase by phase.
#pragma once

#include <cstdint>

#if !defined(__x86_64__)
#include <chrono>
#endif

namespace ctpbench {

// What loops are over: a packet's rays, a step through a node, the test of a block, the clearing of a stack
// after a hit, and an end with the start of the next ray.
enum class FlightPhase : std::uint32_t { packets, nodes, blocks, stacks, ends };
inline constexpr std::uint32_t kFlightPhases = 5;
inline constexpr const char* kFlightPhaseNames[kFlightPhases] = {"packets", "nodes", "blocks", "stacks",
                                                                 "ends"};

struct FlightProfile {
    struct Phase {
        std::uint64_t cycles = 0;  // of the time stamp counter; nanoseconds where there is none
        std::uint64_t items = 0;   // what the loops ran over
        std::uint64_t loops = 0;
    };
    Phase phases[kFlightPhases];

    const Phase& of(FlightPhase p) const { return phases[static_cast<std::uint32_t>(p)]; }
};

// Measures nothing, and costs nothing.
struct NoMeter {
    void start() {}
    void lap(FlightPhase, std::uint32_t) {}
};

class CycleMeter {
public:
    explicit CycleMeter(FlightProfile& into) : into_(&into) {}
    void start() { since_ = now(); }
    // What has passed since the last lap is the phase's, which ran over so many items.
    void lap(FlightPhase phase, std::uint32_t items) {
        const std::uint64_t t = now();
        FlightProfile::Phase& p = into_->phases[static_cast<std::uint32_t>(phase)];
        p.cycles += t - since_, p.items += items, ++p.loops;
        since_ = t;
    }

private:
    static std::uint64_t now() {
#if defined(__x86_64__)
        return __builtin_ia32_rdtsc();
#else
        return static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count());
#endif
    }

    FlightProfile* into_;
    std::uint64_t since_ = 0;
};

}  // namespace ctpbench
