// growth.csv: what a ray costs, by scene, bounce, contender and threads.
#include "report/growth.h"

#include <gtest/gtest.h>

namespace ctpbench {
namespace {

CellResult cell(const std::string& scene, std::size_t triangles, std::uint32_t threads, std::uint32_t bounce,
                std::vector<double> mrays) {
    CellResult c;
    c.workload = {scene, 0, 0.03, "quality"};
    c.contender = {"cpu", "ctp", true, "interleaved", "watertight"};
    c.contender.threads = threads;
    c.triangles = triangles;
    c.checked = c.valid = true;
    c.bounces.resize(1);
    c.bounces[0].bounce = bounce, c.bounces[0].mrays = std::move(mrays);
    return c;
}

TEST(GrowthTable, TellsNanosecondsOfEachSize) {
    Results r;
    r.cells = {cell("grove_10k", 10'000, 0, 0, {4, 10, 5}), cell("grove", 100'000, 1, 4, {2, 2, 2}),
               cell("grove", 100'000, 0, 4, {3})};
    r.cells.back().valid = false;
    EXPECT_EQ(growth_csv(r, 2),
              "scene,triangles,rays,contender,threads,ns_per_ray,lo_ns,hi_ns\r\n"
              "grove_10k,10000,primary,ctp/interleaved,2,200,100,250\r\n"
              "grove,100000,bounce4,ctp/interleaved,1,500,500,500\r\n");
}

}  // namespace
}  // namespace ctpbench
