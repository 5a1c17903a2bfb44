// Two races in one process: the same recorded rays by several intersectors, and the same frames by several
// shaders. Hits and images must be equal bit for bit, else nothing is timed.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "monomorphic/contenders.h"
#include "wavefront/batch.h"
#include "wavefront/frame.h"

namespace ctpbench::monomorphic {

// Seconds of one contender by round; the first contender is what the others are held against.
struct Racer {
    std::string name;
    std::vector<double> seconds;
};
struct Race {
    std::vector<Racer> racers;
    std::uint64_t paths = 0;  // of a round
};

class Differ : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// The rays of every bounce of one frame, at most `limit` of each (0: all), and the hash of their hits.
std::vector<Batch> record_bounces(Stage& stage, const FrameSettings& settings, std::uint32_t limit);

// A round is every batch once, batch by batch, with contenders in alternating order. Throws Differ.
Race race_intersect(Stage& stage, const std::vector<std::string>& names, std::vector<Batch>& batches,
                    std::uint32_t rounds);

// A round is one sample of every pixel; of its time the shade stages count. All intersect by `ctp`, which
// also sorts for those who ask for it. Throws Differ.
Race race_shade(Stage& stage, const std::vector<std::string>& names, const FrameSettings& settings,
                std::uint32_t rounds);

}  // namespace ctpbench::monomorphic
