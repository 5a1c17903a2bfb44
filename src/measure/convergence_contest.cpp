#include "measure/convergence_contest.h"

#include <algorithm>
#include <utility>

#include "measure/frame_series.h"
#include "measure/rounds.h"

namespace ctpbench {

double ConvergenceContest::error_of(std::uint64_t hash, const ImageStorage& image) {
    const auto [error, added] = errors_.try_emplace(hash);
    if (added) error->second = reference_.relmse(image);
    return error->second;
}

bool ConvergenceContest::render(std::uint64_t seed, const ConvergenceEntrant& entrant, Picture& picture,
                                const std::function<bool()>& stop) {
    const std::unique_ptr<FramePipeline> pipeline = entrant.pipeline(seed);
    if (stop()) return false;
    // The first frame also touches the pipeline's memory for the first time; it is rendered again below.
    pipeline->frame(entrant.carry_t, 0, picture.image, {});
    double seconds = 0.0;
    for (std::uint32_t sample = 0; sample < 1u << doublings_; ++sample) {
        if (stop()) return false;
        const auto stages = pipeline->frame(entrant.carry_t, sample, picture.image, {});
        seconds += seconds_of(stages);
        picture.stages.insert(picture.stages.end(), stages.begin(), stages.end());
        const std::uint32_t samples = sample + 1;
        if ((samples & sample) != 0) continue;  // no power of two
        picture.hashes.push_back(picture.image.hash());
        picture.seconds.push_back(seconds);
        picture.relmse.push_back(error_of(picture.hashes.back(), picture.image));
    }
    return true;
}

bool ConvergenceContest::round(std::uint32_t number, const std::vector<ConvergenceEntrant>& entrants,
                               Results& results, const std::function<bool()>& stop) {
    errors_.clear();
    // The first valid entrant of each name: its pictures are what the others' must equal.
    std::map<std::string, std::size_t> first;
    for (std::size_t e = 0; e < entrants.size(); ++e)
        if (results.cells[entrants[e].cell].valid) first.try_emplace(entrants[e].pictures, e);

    std::vector<Picture> pictures(entrants.size());
    for (const std::size_t e : round_order(entrants.size(), number)) {
        if (!results.cells[entrants[e].cell].valid) continue;
        if (!render(first_seed_ + number, entrants[e], pictures[e], stop)) return false;
        if (first.at(entrants[e].pictures) != e) pictures[e].image = {};
    }
    for (std::size_t e = 0; e < entrants.size(); ++e) {
        Picture& picture = pictures[e];
        if (picture.hashes.empty()) continue;
        CellResult& cell = results.cells[entrants[e].cell];
        const std::size_t expected = first.at(entrants[e].pictures);
        if (expected == e) {
            biases_[entrants[e].pictures].add(picture.image);
        } else if (picture.hashes != pictures[expected].hashes) {
            cell.valid = false;
            cell.reason = "its picture of seed " + std::to_string(first_seed_ + number) +
                          " differs from that of " + results.cells[entrants[expected].cell].contender.label();
        }
        add_stages(cell, picture.stages);
        cell.image_hash = picture.hashes.back(), cell.samples = 1u << doublings_;
        cell.convergence.seconds.push_back(std::move(picture.seconds));
        cell.convergence.relmse.push_back(std::move(picture.relmse));
    }
    return true;
}

void ConvergenceContest::conclude(const std::vector<ConvergenceEntrant>& entrants, Results& results) const {
    for (const ConvergenceEntrant& entrant : entrants) {
        CellResult& cell = results.cells[entrant.cell];
        const auto bias = biases_.find(entrant.pictures);
        if (cell.valid && bias != biases_.end()) cell.convergence.bias = bias->second.relmse(reference_);
    }
}

}  // namespace ctpbench
