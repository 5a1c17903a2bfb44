// The contest of one workload: contenders over the same recorded batches, verified first, then timed in
// interleaved rounds.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "kernels/methods/bundles.h"
#include "measure/hit_comparison.h"
#include "measure/hit_judge.h"
#include "measure/results.h"
#include "wavefront/batch.h"
#include "wavefront/batch_tracer.h"
#include "wavefront/intersector.h"

namespace ctpbench {

struct Entrant {
    std::size_t cell;  // in Results::cells
    std::unique_ptr<BatchTracer> tracer;
    bool carry_t;
    std::string hits;                   // those of one name must give the same hits bit for bit, and those
                                        // of recorded_hits what the recorded pipeline found; empty: anything
    bool judged;                        // by the oracle; the oracle itself is not
    std::vector<std::uint64_t> hashes;  // of its hits, by batch
};

// The methods that recorded pipelines use, as a name of hits.
inline constexpr const char* recorded_hits = Watertight::name;

class Contest {
public:
    // `oracle` may be null: hits are then compared among contenders only. `comparison` may be null: then
    // nobody is set beside the recorded frame ray by ray.
    Contest(CpuBackend& backend, const GeometryView& geometry, std::span<Batch> batches,
            const Intersector* oracle, std::uint32_t oracle_rays, HitComparison* comparison = nullptr);

    // Traces every batch untimed, which also warms up; judges the hits and sets the cell's verdict. Returns
    // one row per batch, without a time.
    std::vector<Row> verify(Entrant& entrant, CellResult& cell);

    // One round over all valid entrants; appends to each cell's series. Stops early, keeping nothing of the
    // round, when `stop` says so.
    std::vector<Row> round(std::uint32_t number, std::vector<Entrant>& entrants, Results& results,
                           const std::function<bool()>& stop);

    // Share of the reference's hits that are on spheres.
    double sphere_hit_share() const;

private:
    GeometryView geometry_;
    std::span<Batch> batches_;
    HitJudge judge_;
    HitComparison* comparison_;
    std::map<std::string, std::vector<std::uint64_t>>
        expected_;  // by name, hashes by batch; 0: not known yet
    bool counted_ = false;
    std::size_t sphere_hits_ = 0, hits_seen_ = 0;
};

}  // namespace ctpbench
