// The contest of errors: each contender renders independent progressive pictures, whose error and time are
// taken after 1, 2, 4, ... samples per pixel. A round is one picture of each contender, from a seed of its
// own. No more pictures are kept than there are different ones in a round.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "measure/image_bias.h"
#include "measure/reference_image.h"
#include "measure/results.h"
#include "wavefront/frame.h"

namespace ctpbench {

struct ConvergenceEntrant {
    std::size_t cell;  // in Results::cells
    // A pipeline that draws its random numbers from this seed.
    std::function<std::unique_ptr<FramePipeline>(std::uint64_t seed)> pipeline;
    bool carry_t;
    std::string pictures;  // entrants with the same name here must render the same pictures bit for bit
};

class ConvergenceContest {
public:
    // Pictures have 2^doublings samples per pixel; round r has the seed first_seed + r, which must not be one
    // of the reference's. The reference must outlive the contest.
    ConvergenceContest(const ReferenceImage& reference, std::uint32_t doublings, std::uint64_t first_seed)
        : reference_(reference), doublings_(doublings), first_seed_(first_seed) {}

    // One round over all valid entrants, added to their cells. A picture that differs from that of the first
    // entrant of the same name makes its cell invalid. `stop` is asked before each frame; false, and nothing
    // kept of the round, when it says so.
    bool round(std::uint32_t number, const std::vector<ConvergenceEntrant>& entrants, Results& results,
               const std::function<bool()>& stop);

    // Sets the bias of every valid cell from the rounds so far.
    void conclude(const std::vector<ConvergenceEntrant>& entrants, Results& results) const;

private:
    struct Picture {
        std::vector<std::uint64_t> hashes;  // by doublings, as all here; empty: not rendered
        std::vector<double> seconds, relmse;
        std::vector<StageTime> stages;
        ImageStorage image;
    };
    bool render(std::uint64_t seed, const ConvergenceEntrant& entrant, Picture& picture,
                const std::function<bool()>& stop);
    double error_of(std::uint64_t hash, const ImageStorage& image);

    const ReferenceImage& reference_;
    std::uint32_t doublings_;
    std::uint64_t first_seed_;
    std::map<std::uint64_t, double> errors_;   // relMSE of the round's images, by their hashes
    std::map<std::string, ImageBias> biases_;  // by the pictures' name
};

}  // namespace ctpbench
