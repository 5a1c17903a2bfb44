// The contest of whole frames: each contender renders the same samples with a pipeline of its own, verified
// first, then timed stage by stage in interleaved rounds. A round is one more sample per pixel.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "measure/hit_judge.h"
#include "measure/results.h"
#include "wavefront/frame.h"

namespace ctpbench {

// Contenders of one name trace the same rays and must render the same image: those of one backend who leave
// surfaces, and end paths, in the same way. Where hits depend on the tree, each has a name of its own.
std::string pictures_of(const Contender& contender, bool exact);

struct FrameEntrant {
    std::size_t cell;  // in Results::cells
    std::unique_ptr<FramePipeline> pipeline;
    bool carry_t;
    bool exact;  // must give the hits and images of its backend's first exact entrant bit for bit
    ImageStorage image{};
};

class FrameContest {
public:
    // `oracle` may be null.
    FrameContest(const GeometryView& geometry, CpuBackend& backend, const Intersector* oracle,
                 std::uint32_t oracle_rays);

    // Renders a frame untimed, which also warms up; judges the hits of every bounce (of camera rays alone,
    // where an offset leaves others on the surface they come from) and compares hits and image with those of
    // the first exact entrant of the same pictures; other backends have others, since the sine of an angle is
    // not the same number on every device. Sets the cell's verdict; returns rows without a time.
    std::vector<Row> verify(FrameEntrant& entrant, CellResult& cell);

    // One round over all valid entrants. Stops early, keeping nothing of the round, when `stop` says so.
    std::vector<Row> round(std::uint32_t number, std::vector<FrameEntrant>& entrants, Results& results,
                           const std::function<bool()>& stop);

private:
    GeometryView geometry_;
    CpuBackend& backend_;
    const Intersector* oracle_;
    std::uint32_t oracle_rays_;
    std::map<std::string, HitJudge> judges_;  // of those who trace the same rays
    // Of those who must render the same, hashes of the first exact entrant: hits by bounce, then the image.
    std::map<std::string, std::vector<std::uint64_t>> expected_;
};

}  // namespace ctpbench
