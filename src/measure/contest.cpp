#include "measure/contest.h"

#include "measure/rounds.h"

namespace ctpbench {

Contest::Contest(CpuBackend& backend, const GeometryView& geometry, std::span<Batch> batches,
                 const Intersector* oracle, std::uint32_t oracle_rays, HitComparison* comparison)
    : geometry_(geometry),
      batches_(batches),
      judge_(backend, geometry, oracle, oracle_rays),
      comparison_(comparison) {
    for (const Batch& batch : batches) expected_[recorded_hits].push_back(batch.hit_hash);
}

std::vector<Row> Contest::verify(Entrant& entrant, CellResult& cell) {
    std::vector<Row> rows;
    const bool exact = !entrant.hits.empty();
    const bool counts = exact && !counted_;
    std::vector<std::uint64_t>& expected = expected_[entrant.hits];
    expected.resize(batches_.size());
    std::size_t differing = 0;
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        Batch& batch = batches_[b];
        const std::uint64_t hash = entrant.tracer->trace(batch, entrant.carry_t).hash;
        entrant.hashes.push_back(hash);
        if (expected[b] == 0) expected[b] = hash;
        if (counts) {
            const HitColumns columns = entrant.tracer->hits().view();
            for (std::uint32_t i = 0; i < batch.rays.size(); ++i) {
                hits_seen_ += columns.primitive[i] != kNoPrimitive;
                sphere_hits_ +=
                    columns.primitive[i] != kNoPrimitive && columns.primitive[i] >= geometry_.first_sphere();
            }
        }
        if (exact && hash != expected[b]) ++differing;
        if (entrant.judged && judge_.can_judge())
            cell.verdict += judge_.judge_hits(b, batch, *entrant.tracer, hash);
        BounceSeries& series = cell.bounces.emplace_back();
        series.bounce = batch.bounce;
        if (comparison_ != nullptr)
            series.against_reference = comparison_->compare(b, batch, *entrant.tracer, hash);
        rows.push_back({entrant.cell, "intersect", batch.bounce, 0, batch.active,
                        static_cast<std::uint32_t>(batch.rays.size()), 0.0, hash});
    }
    counted_ = counted_ || counts;
    cell.checked = judge_.can_judge();
    cell.valid = true;
    if (differing > 0) {
        cell.valid = false;
        cell.reason = "hits differ from the reference's in " + std::to_string(differing) + " of " +
                      std::to_string(batches_.size()) + " batches";
    } else if (!cell.verdict.accepted(exact)) {
        cell.valid = false;
        cell.reason = "the oracle disagrees: " + cell.verdict.text();
    }
    return rows;
}

std::vector<Row> Contest::round(std::uint32_t number, std::vector<Entrant>& entrants, Results& results,
                                const std::function<bool()>& stop) {
    std::vector<Row> rows;
    std::vector<double> frame_seconds(entrants.size(), 0.0);
    std::vector<std::vector<double>> mrays(entrants.size());  // by batch
    std::uint64_t frame_rays = 0, timed_rays = 0;
    for (const Batch& batch : batches_) frame_rays += batch.active, timed_rays += batch.rays.size();
    for (std::size_t e : round_order(entrants.size(), number)) {
        const Entrant& entrant = entrants[e];
        if (!results.cells[entrant.cell].valid) continue;
        for (std::size_t b = 0; b < batches_.size(); ++b) {
            if (stop()) return {};
            Batch& batch = batches_[b];
            const auto [seconds, hash] = entrant.tracer->trace(batch, entrant.carry_t);
            const auto count = static_cast<std::uint32_t>(batch.rays.size());
            if (hash != entrant.hashes[b]) {
                CellResult& cell = results.cells[entrant.cell];
                cell.valid = false;
                cell.reason = "hits changed between two runs on the same rays, at bounce " +
                              std::to_string(batch.bounce);
            }
            rows.push_back(
                {entrant.cell, "intersect", batch.bounce, number, batch.active, count, seconds, hash});
            mrays[e].push_back(rows.back().mrays_per_second());
            // A batch stands for all paths that were active at its bounce.
            frame_seconds[e] += seconds * batch.active / count;
        }
    }
    for (std::size_t e = 0; e < entrants.size(); ++e) {
        if (frame_seconds[e] <= 0.0) continue;
        CellResult& cell = results.cells[entrants[e].cell];
        cell.add("intersect", timed_rays, static_cast<double>(frame_rays) / frame_seconds[e] * 1e-6,
                 frame_seconds[e]);
        for (std::size_t b = 0; b < batches_.size(); ++b) cell.bounces[b].mrays.push_back(mrays[e][b]);
    }
    return rows;
}

double Contest::sphere_hit_share() const {
    return hits_seen_ == 0 ? 0.0 : static_cast<double>(sphere_hits_) / static_cast<double>(hits_seen_);
}

}  // namespace ctpbench
