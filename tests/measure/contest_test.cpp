// A contender with wrong hits must never be timed into a table.
#include "measure/contest.h"

#include <gtest/gtest.h>

#include "oracle/embree.h"
#include "support.h"
#include "wavefront/cpu_tracer.h"
#include "wavefront/frames.h"

namespace ctpbench {
namespace {

// Traces like the contender it wraps, then spoils some of the hits.
class Broken final : public Intersector {
public:
    Broken(const Intersector& sound, std::uint32_t every, bool sometimes = false)
        : sound_(sound), every_(every), sometimes_(sometimes) {}
    void intersect(CpuBackend& backend, const IntersectBuffers& io, bool carry_t) const override {
        sound_.intersect(backend, io, carry_t);
        if (sometimes_ && ++calls_ <= 1) return;
        for (std::uint32_t i = 0; i < io.count; i += every_)
            io.hits.store(i, {test::kInfinity, kNoPrimitive, 0, 0});
    }
    std::size_t bytes() const override { return 0; }

private:
    const Intersector& sound_;
    std::uint32_t every_;
    bool sometimes_;
    mutable int calls_ = 0;
};

class ContestTest : public testing::Test {
protected:
    ContestTest() : scene_(test::soup(3000, 100, 6)), stage_(scene_, 2) {
        restart_ =
            make_intersector("restart", "watertight", stage_.forest.layout_input(stage_.view.geometry()));
        if (!embree_version().empty()) oracle_ = make_embree(scene_, EmbreeMode::robust, 2);
        test::render(stage_, test::looking_from({0, 0, 2}, {0, 0, 1}), {64, 64, 1, 1}, 1, "ctp",
                     [&](const BounceView& view) {
                         batches_.push_back(record_batch(view.bounce, view.rays, view.slots, 2000));
                     });
    }
    std::unique_ptr<BatchTracer> traces(const Intersector& intersector) {
        return std::make_unique<CpuTracer>(backend_, intersector, view_.geometry().extent);
    }
    CellResult verdict_on(const Intersector& intersector, bool exact = true) {
        Contest contest(backend_, view_.geometry(), batches_, oracle_.get(), 0);
        CellResult first, cell;
        Entrant reference{0, traces(*ctp_), true, recorded_hits, true, {}};
        contest.verify(reference, first);
        EXPECT_TRUE(first.valid) << first.reason;
        Entrant entrant{0, traces(intersector), true, exact ? recorded_hits : "", true, {}};
        const std::vector<Row> rows = contest.verify(entrant, cell);
        EXPECT_EQ(rows.size(), batches_.size());
        EXPECT_EQ(rows[0].hit_hash, entrant.hashes[0]);
        return cell;
    }

    Scene scene_;
    test::Stage stage_;
    CpuBackend& backend_ = stage_.backend;
    const SceneView& view_ = stage_.view;
    const Intersector* ctp_ = stage_.intersector.get();
    std::unique_ptr<Intersector> restart_;
    std::unique_ptr<Intersector> oracle_;
    std::vector<Batch> batches_;
};

TEST_F(ContestTest, AcceptsSoundContenders) {
    const CellResult cell = verdict_on(*restart_);
    EXPECT_TRUE(cell.valid) << cell.reason;
    if (oracle_) {
        EXPECT_EQ(cell.verdict.faults(), 0u) << cell.verdict.text();
    }
}

TEST_F(ContestTest, RejectsHitsThatDifferFromTheReference) {
    const CellResult cell = verdict_on(Broken(*ctp_, 1999));
    EXPECT_FALSE(cell.valid);
    EXPECT_NE(cell.reason.find("differ"), std::string::npos);
}

TEST_F(ContestTest, TheOracleRejectsWhatItKnowsToBeWrong) {
    if (!oracle_) GTEST_SKIP() << "built without Embree";
    const CellResult cell = verdict_on(Broken(*ctp_, 50), false);
    EXPECT_FALSE(cell.valid);
    EXPECT_GT(cell.verdict.missed, 0u) << cell.verdict.text();
}

TEST_F(ContestTest, NoticesHitsThatChangeBetweenRuns) {
    Contest contest(backend_, view_.geometry(), batches_, oracle_.get(), 0);
    const Broken broken(*ctp_, 50, true);
    Results results;
    results.cells.resize(2);
    std::vector<Entrant> entrants;
    entrants.push_back({0, traces(*ctp_), true, recorded_hits, true, {}});
    entrants.push_back({1, traces(broken), true, {}, false, {}});
    for (Entrant& e : entrants) contest.verify(e, results.cells[e.cell]);
    results.cells[1].valid = true;
    contest.round(0, entrants, results, [] { return false; });
    EXPECT_TRUE(results.cells[0].valid);
    EXPECT_FALSE(results.cells[1].valid);
}

TEST_F(ContestTest, ComparesEveryRayOfABounceWithTheRecordedFrame) {
    std::vector<HitStorage> found;
    const auto tracer = traces(*ctp_);
    std::size_t hit = 0, spoilt = 0;
    for (Batch& batch : batches_) {
        tracer->trace(batch, true);
        found.push_back(tracer->hits());
        for (std::uint32_t i = 0; i < batch.rays.size(); i += 7)
            spoilt += found.back().view().primitive[i] != kNoPrimitive;
        hit += batch.rays.size();
    }
    HitComparison comparison(backend_, view_.geometry(), found);
    Contest contest(backend_, view_.geometry(), batches_, nullptr, 10, &comparison);
    CellResult sound, broken;
    Entrant reference{0, traces(*restart_), true, {}, false, {}};
    contest.verify(reference, sound);
    const Broken spoils(*ctp_, 7);
    Entrant other{1, traces(spoils), true, {}, false, {}};
    contest.verify(other, broken);
    ASSERT_EQ(sound.bounces.size(), batches_.size());
    std::size_t rays = 0, wrong = 0;
    for (std::size_t b = 0; b < batches_.size(); ++b) {
        EXPECT_EQ(sound.bounces[b].bounce, b);
        EXPECT_EQ(sound.bounces[b].against_reference.mismatch_rate(), 0.0);
        rays += broken.bounces[b].against_reference.rays;
        wrong += broken.bounces[b].against_reference.rays - broken.bounces[b].against_reference.match;
    }
    EXPECT_EQ(rays, hit) << "all of them, whatever the oracle's share";
    EXPECT_EQ(wrong, spoilt);
    EXPECT_GT(spoilt, 50u);
}

TEST_F(ContestTest, ARoundTimesEveryEntrantOnEveryBatch) {
    Contest contest(backend_, view_.geometry(), batches_, oracle_.get(), 0);
    Results results;
    results.cells.resize(2);
    std::vector<Entrant> entrants;
    entrants.push_back({0, traces(*ctp_), true, recorded_hits, true, {}});
    entrants.push_back({1, traces(*restart_), true, recorded_hits, true, {}});
    for (Entrant& e : entrants) contest.verify(e, results.cells[e.cell]);
    for (std::uint32_t round = 0; round < 3; ++round) {
        const std::vector<Row> rows = contest.round(round, entrants, results, [] { return false; });
        EXPECT_EQ(rows.size(), 2 * batches_.size());
        for (const Row& row : rows) {
            EXPECT_GT(row.seconds, 0.0);
            EXPECT_EQ(results.cells[row.cell].bounces[row.bounce].mrays[round], row.mrays_per_second());
        }
    }
    EXPECT_EQ(results.cells[0].find("intersect")->mrays.size(), 3u);
    EXPECT_EQ(results.cells[1].find("intersect")->mrays.size(), 3u);
    for (const CellResult& cell : results.cells) {
        ASSERT_EQ(cell.bounces.size(), batches_.size());
        for (const BounceSeries& series : cell.bounces) {
            EXPECT_EQ(series.mrays.size(), 3u);
            EXPECT_EQ(series.against_reference.rays, 0u) << "nobody asked for a comparison";
        }
    }
    EXPECT_TRUE(contest.round(3, entrants, results, [] { return true; }).empty())
        << "a round cut short leaves nothing";
    EXPECT_EQ(results.cells[0].find("intersect")->mrays.size(), 3u);
}

}  // namespace
}  // namespace ctpbench
