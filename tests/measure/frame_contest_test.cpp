// A pipeline that renders another image, or hits something else, must never be timed into a table.
#include "measure/frame_contest.h"

#include <gtest/gtest.h>

#include "oracle/embree.h"
#include "support.h"
#include "wavefront/frames.h"

namespace ctpbench {
namespace {

// Shades like the contender it wraps, then spoils some paths: their light, or where they go next.
class Broken final : public Shader {
public:
    enum class What { light, paths };
    Broken(std::unique_ptr<Shader> sound, What what, int from_frame = 0)
        : sound_(std::move(sound)), what_(what), from_frame_(from_frame) {}
    PathOrder order() const override { return sound_->order(); }
    MaterialWords words() const override { return sound_->words(); }
    void count(const MaterialInput&, const CountingPlace&) const override {}
    void shade(CpuBackend& backend, const ShadeBuffers& io, const ShadeWork& work) const override {
        if (io.bounce == 0) ++frames_;
        sound_->shade(backend, io, work);
        if (io.bounce != 0 || frames_ <= from_frame_) return;
        if (what_ == What::light) {
            io.pixels.radiance_g[7] += 0.25f;
        } else {
            for (std::uint32_t slot = 0; slot < 64; ++slot) io.rays.dx[slot] = 1.0f, io.rays.dy[slot] = 0.5f;
        }
    }

private:
    std::unique_ptr<Shader> sound_;
    What what_;
    int from_frame_;
    mutable int frames_ = 0;
};

// A cell of the default methods.
CellResult default_cell() {
    CellResult cell;
    cell.contender.methods = "watertight";
    return cell;
}

class FrameContestTest : public testing::Test {
protected:
    FrameContestTest()
        : scene_(test::soup(3000, 100, 6)),
          stage_(scene_, 2),
          renderer_(std::make_shared<Renderer>(stage_.backend, stage_.view,
                                               test::looking_from({0, 0, 2}, {0, 0, 1}),
                                               FrameSettings{64, 48, 2, 1, true})) {
        if (!embree_version().empty()) oracle_ = make_embree(scene_, EmbreeMode::robust, 2);
    }
    FrameContest contest() {
        return FrameContest(stage_.view.geometry(), stage_.backend, oracle_.get(), 1000);
    }
    std::unique_ptr<Shader> shader(const char* name) { return make_shader(name, stage_.materials); }
    FrameEntrant entrant(std::size_t cell, std::unique_ptr<Shader> shader) {
        return {cell, std::make_unique<CpuPipeline>(renderer_, *stage_.intersector, std::move(shader)), true,
                true};
    }
    CellResult verdict_on(std::unique_ptr<Shader> contender) {
        FrameContest judged = contest();
        CellResult first = default_cell(), cell = default_cell();
        FrameEntrant reference = entrant(0, shader("ctp")), other = entrant(0, std::move(contender));
        judged.verify(reference, first);
        EXPECT_TRUE(first.valid) << first.reason;
        EXPECT_EQ(first.verdict.rays > 0, oracle_ != nullptr);
        judged.verify(other, cell);
        return cell;
    }

    Scene scene_;
    test::Stage stage_;
    std::shared_ptr<Renderer> renderer_;
    std::unique_ptr<Intersector> oracle_;
};

TEST_F(FrameContestTest, AcceptsEveryShadeStrategy) {
    for (const std::string& name : shade_strategies()) {
        const CellResult cell = verdict_on(shader(name.c_str()));
        EXPECT_TRUE(cell.valid) << name << ": " << cell.reason;
    }
}

TEST_F(FrameContestTest, RejectsAnotherImage) {
    const CellResult cell = verdict_on(std::make_unique<Broken>(shader("ctp"), Broken::What::light));
    EXPECT_FALSE(cell.valid);
    EXPECT_EQ(cell.reason, "the image differs from the first contender's");
}

TEST_F(FrameContestTest, RejectsOtherHitsAndSaysFromWhere) {
    const CellResult cell = verdict_on(std::make_unique<Broken>(shader("ctp"), Broken::What::paths));
    EXPECT_FALSE(cell.valid);
    EXPECT_EQ(cell.reason, "hits differ from the first contender's, from bounce 1 on");
}

// Rays that a poor offset leaves on a surface have no right answer; they are compared among contenders alone.
TEST_F(FrameContestTest, JudgesCameraRaysAloneWhereAnOffsetIsPoor) {
    if (!oracle_) GTEST_SKIP() << "needs an oracle";
    std::size_t judged_rays[2];
    for (const bool poor : {false, true}) {
        FrameContest judged = contest();
        CellResult first = default_cell(), other = default_cell();
        if (poor) first.contender.offset = other.contender.offset = "constant_epsilon";
        FrameEntrant one = entrant(0, shader("ctp"));
        FrameEntrant two = entrant(0, std::make_unique<Broken>(shader("ctp"), Broken::What::paths));
        judged.verify(one, first), judged.verify(two, other);
        EXPECT_TRUE(first.valid) << first.reason;
        EXPECT_FALSE(other.valid);
        judged_rays[poor] = first.verdict.rays;
    }
    EXPECT_GT(judged_rays[1], 0u);
    EXPECT_GT(judged_rays[0], judged_rays[1]);
}

TEST_F(FrameContestTest, NoticesAnImageThatDiffersInARoundOnly) {
    FrameContest judged = contest();
    Results results;
    results.cells.assign(2, default_cell());
    std::vector<FrameEntrant> entrants;
    entrants.push_back(entrant(0, shader("ctp")));
    // Sound while it is verified and in the first round.
    entrants.push_back(entrant(1, std::make_unique<Broken>(shader("sort"), Broken::What::light, 2)));
    for (FrameEntrant& e : entrants) judged.verify(e, results.cells[e.cell]);
    const auto never = [] { return false; };
    judged.round(0, entrants, results, never);
    EXPECT_TRUE(results.cells[1].valid) << results.cells[1].reason;
    judged.round(1, entrants, results, never);
    EXPECT_TRUE(results.cells[0].valid);
    EXPECT_FALSE(results.cells[1].valid);
}

TEST_F(FrameContestTest, ARoundIsASampleAndTimesEveryStage) {
    FrameContest judged = contest();
    Results results;
    results.cells.assign(2, default_cell());
    std::vector<FrameEntrant> entrants;
    entrants.push_back(entrant(0, shader("ctp")));
    entrants.push_back(entrant(1, shader("sort")));
    for (FrameEntrant& e : entrants) judged.verify(e, results.cells[e.cell]);
    for (std::uint32_t round = 0; round < 3; ++round) {
        for (const Row& row : judged.round(round, entrants, results, [] { return false; })) {
            EXPECT_GT(row.seconds, 0.0);
            EXPECT_EQ(row.round, round);
            EXPECT_EQ(row.image_hash != 0, row.kernel == "blend");
        }
    }
    for (const CellResult& cell : results.cells) {
        EXPECT_EQ(cell.samples, 3u);
        EXPECT_EQ(cell.image_hash, results.cells[0].image_hash);
        ASSERT_NE(cell.find("copy"), nullptr);
        EXPECT_EQ(cell.find("shade")->mrays.size(), 3u);
        EXPECT_EQ(cell.find("shade")->rays, cell.find("intersect")->rays);
    }
    EXPECT_EQ(results.cells[0].find("sort"), nullptr);
    EXPECT_TRUE(judged.round(3, entrants, results, [] { return true; }).empty());
    EXPECT_EQ(results.cells[0].samples, 3u) << "a round cut short leaves nothing";
}

}  // namespace
}  // namespace ctpbench
