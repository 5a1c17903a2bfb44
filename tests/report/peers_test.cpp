// peers.csv: a line per bounce, contender and number of threads, set beside rtcIntersect1 with as many
// threads.
#include "report/peers.h"

#include <gtest/gtest.h>

#include "report/figures.h"

namespace ctpbench {
namespace {

const std::string kHeader =
    "scene,rays,contender,threads,median_mrays_s,ratio_to_rtcintersect1,ratio_lo,ratio_hi,mismatch_rate\r\n";

BounceSeries bounce(std::uint32_t number, std::vector<double> mrays, std::size_t mismatches = 0) {
    BounceSeries series;
    series.bounce = number, series.mrays = std::move(mrays);
    series.against_reference.rays = 1000, series.against_reference.tie = 5;
    series.against_reference.match = 995 - mismatches, series.against_reference.leak = mismatches;
    return series;
}

CellResult cell(const std::string& strategy, std::uint32_t threads, std::vector<BounceSeries> bounces) {
    CellResult c;
    c.workload = {"room", 0, 0.03, "quality"};
    c.contender = {"cpu", strategy, true, "single", "watertight"};
    if (strategy.starts_with("embree"))
        c.contender.traversal = c.contender.methods = c.contender.types = own_way;
    c.contender.threads = threads;
    c.checked = c.valid = true;
    c.bounces = std::move(bounces);
    return c;
}

TEST(PeersTable, ComparesWithIntersect1OfTheSameBounceAndThreads) {
    Results r;
    r.cells = {cell("ctp", 1, {bounce(0, {2, 4, 3}), bounce(4, {1, 1, 1})}),
               cell("ctp", 2, {bounce(0, {8, 8, 8}), bounce(4, {2, 2, 2})}),
               cell("embree_default", 1, {bounce(0, {4, 8, 6}, 3), bounce(4, {2, 2, 2}, 1)}),
               cell("embree_default", 2, {bounce(0, {8, 4, 16}, 3), bounce(4, {1, 1, 1}, 1)})};
    EXPECT_EQ(peers_csv(r, 2), kHeader +
                                   "room,primary,ctp,1,3,0.5,0.5,0.5,0\r\n"
                                   "room,primary,ctp,2,8,1,0.5,2,0\r\n"
                                   "room,primary,embree_default,1,6,1,1,1,0.003\r\n"
                                   "room,primary,embree_default,2,8,1,1,1,0.003\r\n"
                                   "room,bounce4,ctp,1,1,0.5,0.5,0.5,0\r\n"
                                   "room,bounce4,ctp,2,2,2,2,2,0\r\n"
                                   "room,bounce4,embree_default,1,2,1,1,1,0.001\r\n"
                                   "room,bounce4,embree_default,2,1,1,1,1,0.001\r\n");
}

TEST(PeersTable, HasTheRunsThreadsWhereNoneAreAskedFor) {
    Results r;
    r.cells = {cell("ctp", 0, {bounce(1, {3, 3, 3})}), cell("embree_default", 0, {bounce(1, {2, 2, 2})})};
    r.cells[0].contender.traversal = "interleaved";
    for (CellResult& c : r.cells) c.workload.spheres = 200;
    EXPECT_EQ(peers_csv(r, 7), kHeader +
                                   "room/200,bounce1,ctp/interleaved,7,3,1.5,1.5,1.5,0\r\n"
                                   "room/200,bounce1,embree_default,7,2,1,1,1,0\r\n");
}

TEST(PeersTable, LeavesOutWhatIsRejectedRendersOrRunsElsewhere) {
    Results r;
    r.cells = {cell("ctp", 0, {bounce(0, {3})}), cell("ctp", 0, {bounce(0, {3})}),
               cell("oop", 0, {bounce(0, {3})}), cell("typed_leaves", 0, {bounce(0, {3})}),
               cell("restart", 0, {bounce(0, {})})};
    r.cells[1].contender.backend = "cuda";
    r.cells[2].valid = false;
    r.cells[3].contender.shade = "ctp";
    r.cells[0].bounces[0].against_reference = {};
    EXPECT_EQ(peers_csv(r, 1), kHeader + "room,primary,ctp,1,3,,,,\r\n")
        << "no ratio without the yardstick, no rate where nobody was compared";
}

TEST(Figures, YardsticksHaveAsManyThreads) {
    Results r;
    r.cells = {cell("ctp", 1, {}), cell("embree_robust", 0, {}), cell("embree_robust", 2, {})};
    EXPECT_EQ(yardstick_of(r.cells[0], r), nullptr);
    r.cells.push_back(cell("embree_robust", 1, {}));
    EXPECT_EQ(yardstick_of(r.cells[0], r), &r.cells[3]);
    EXPECT_EQ(reference_of(r.cells[2], r, "ctp"), nullptr) << "another number of threads";
}

}  // namespace
}  // namespace ctpbench
