// The contest of whole frames: each contender renders the same samples with a pipeline of its own, verified
// first, then timed stage by stage in interleaved rounds. A round is one more sample per pixel.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "measure/hit_judge.h"
#include "measure/results.h"
#include "wavefront/renderer.h"

namespace ctpbench {

struct FrameEntrant {
    std::size_t cell;  // in Results::cells
    const Intersector* intersector;
    std::unique_ptr<Shader> shader;
    bool carry_t;
    bool exact;  // must give the first exact entrant's hits and images bit for bit
    ImageStorage image{};
};

class FrameContest {
public:
    // `oracle` may be null.
    FrameContest(Renderer& renderer, const GeometryView& geometry, CpuBackend& backend,
                 const Intersector* oracle, std::uint32_t oracle_rays);

    // Renders a frame untimed, which also warms up; judges the hits of every bounce and compares hits and
    // image with the first exact entrant's. Sets the cell's verdict; returns rows without a time.
    std::vector<Row> verify(FrameEntrant& entrant, CellResult& cell);

    // One round over all valid entrants. Stops early, keeping nothing of the round, when `stop` says so.
    std::vector<Row> round(std::uint32_t number, std::vector<FrameEntrant>& entrants, Results& results,
                           const std::function<bool()>& stop);

private:
    Renderer& renderer_;
    HitJudge judge_;
    std::uint32_t oracle_rays_;
    std::vector<std::uint64_t>
        expected_;  // hashes of the first exact entrant: hits by bounce, then the image
};

}  // namespace ctpbench
