#include "measure/frame_contest.h"

#include <algorithm>

#include "kernels/methods/offset_waechter_binder.h"
#include "measure/frame_series.h"
#include "measure/rounds.h"
#include "wavefront/methods.h"
#include "wavefront/type_choice.h"

namespace ctpbench {
namespace {

std::vector<Row> rows_of(std::size_t cell, std::uint32_t round, const std::vector<StageTime>& stages,
                         std::uint64_t image_hash) {
    std::vector<Row> rows;
    for (const StageTime& s : stages) {
        Row& row = rows.emplace_back();
        row.cell = cell, row.kernel = s.kernel, row.bounce = s.bounce, row.round = round;
        row.active_rays = row.rays = s.rays, row.seconds = s.seconds;
        row.dropped = s.dropped, row.clamped = s.clamped;
        row.start_seconds = s.start;
        if (row.kernel == "blend") row.image_hash = image_hash;
    }
    return rows;
}

// Whether rays leave surfaces so that where they start is beyond doubt. With other offsets some start on the
// surface itself, or behind it, and whether they meet it again is rounding, of which there is no judge; nor
// does the oracle know of primitives that are left out.
bool starts_are_sound(const Contender& c) { return offset_of(c.methods, c.offset) == WaechterBinder::name; }

}  // namespace

std::string pictures_of(const Contender& c, bool exact) {
    // Synthetic materials draw random numbers of their own; narrowed kernels show what full ones do.
    const std::string materials = type_choice(c.types).synthetic.any() ? c.types_part() : "";
    return exact ? c.backend + "/" + c.methods + materials + c.exchanged() : c.label();
}

FrameContest::FrameContest(const GeometryView& geometry, CpuBackend& backend, const Intersector* oracle,
                           std::uint32_t oracle_rays)
    : geometry_(geometry), backend_(backend), oracle_(oracle), oracle_rays_(oracle_rays) {}

std::vector<Row> FrameContest::verify(FrameEntrant& entrant, CellResult& cell) {
    std::vector<std::uint64_t> hashes;
    ImageStorage image;
    const std::string pictures = pictures_of(cell.contender, entrant.exact);
    std::vector<std::uint64_t>& expected = expected_[pictures];
    HitJudge& judge = judges_.try_emplace(pictures, backend_, geometry_, oracle_, oracle_rays_).first->second;
    std::vector<StageTime> stages =
        entrant.pipeline->frame(entrant.carry_t, 0, image, [&](const BounceView& view) {
            // In the order of the slots, which does not depend on how a strategy has reordered its paths.
            std::vector<std::uint32_t> slots = view.slots;
            std::sort(slots.begin(), slots.end());
            Batch all = record_batch(view.bounce, view.rays, slots, 0, view.excluded);
            const std::uint64_t hash = record_hits(all, view.hits).hash();
            if (judge.can_judge() && (view.bounce == 0 || starts_are_sound(cell.contender))) {
                Batch batch = record_batch(view.bounce, view.rays, slots, oracle_rays_, view.excluded);
                HitStorage hits = record_hits(batch, view.hits);
                cell.verdict += judge.judge_hits(view.bounce, batch, hits, hash);
            }
            hashes.push_back(hash);
        });
    hashes.push_back(image.hash());
    for (StageTime& s : stages) s.seconds = 0.0;

    cell.checked = judge.can_judge();
    cell.valid = true;
    if (entrant.exact && expected.empty()) expected = hashes;
    if (entrant.exact && hashes != expected) {
        cell.valid = false;
        const auto [ours, first] =
            std::mismatch(hashes.begin(), hashes.end(), expected.begin(), expected.end());
        const bool is_image = ours + 1 >= hashes.end() && first + 1 >= expected.end();
        cell.reason = is_image ? "the image differs from the first contender's"
                               : "hits differ from the first contender's, from bounce " +
                                     std::to_string(ours - hashes.begin()) + " on";
    } else if (!cell.verdict.accepted(entrant.exact)) {
        cell.valid = false;
        cell.reason = "the oracle disagrees: " + cell.verdict.text();
    }
    return rows_of(entrant.cell, 0, stages, hashes.back());
}

std::vector<Row> FrameContest::round(std::uint32_t number, std::vector<FrameEntrant>& entrants,
                                     Results& results, const std::function<bool()>& stop) {
    struct Frame {
        std::vector<StageTime> stages;
        std::uint64_t image_hash = 0;
    };
    std::vector<Frame> frames(entrants.size());
    for (std::size_t e : round_order(entrants.size(), number)) {
        FrameEntrant& entrant = entrants[e];
        if (!results.cells[entrant.cell].valid) continue;
        if (stop()) return {};
        frames[e].stages = entrant.pipeline->frame(entrant.carry_t, number, entrant.image, {});
        frames[e].image_hash = entrant.image.hash();
    }
    std::vector<Row> rows;
    std::map<std::string, std::uint64_t> expected_images;
    for (std::size_t e = 0; e < entrants.size(); ++e) {
        CellResult& cell = results.cells[entrants[e].cell];
        if (frames[e].stages.empty()) continue;
        std::uint64_t& expected = expected_images[pictures_of(cell.contender, entrants[e].exact)];
        if (entrants[e].exact && expected == 0) expected = frames[e].image_hash;
        if (entrants[e].exact && frames[e].image_hash != expected) {
            cell.valid = false;
            cell.reason =
                "its image differs from the first contender's after sample " + std::to_string(number);
        }
        add_stages(cell, frames[e].stages);
        cell.image_hash = frames[e].image_hash, cell.samples = number + 1;
        const std::vector<Row> of_frame =
            rows_of(entrants[e].cell, number, frames[e].stages, frames[e].image_hash);
        rows.insert(rows.end(), of_frame.begin(), of_frame.end());
    }
    return rows;
}

}  // namespace ctpbench
