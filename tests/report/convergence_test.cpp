#include "report/convergence.h"

#include <gtest/gtest.h>

namespace ctpbench {
namespace {

CellResult cell() {
    CellResult c;
    c.workload = {"conference", 10, 0.03, "quality"};
    c.contender = {"cpu", "restart", true, "single", "watertight", "sort"};
    c.scene_source = "mesh", c.triangles = 12;
    c.checked = c.valid = true;
    return c;
}

const std::string kContender =
    "scene,scene_source,triangles,spheres,backend,strategy,shade,methods,offset,bounces,roulette,";

TEST(ConvergenceTable, HasALinePerDoubling) {
    Results results;
    CellResult& c = results.cells.emplace_back(cell());
    c.convergence.seconds = {{1, 2}, {3, 5}, {1.5, 4}};
    c.convergence.relmse = {{0.3, 0.15}, {0.2, 0.12}, {0.1, 0.09}};
    CellResult& limited = results.cells.emplace_back(cell());
    limited.contender.bounce_limit = 2, limited.contender.roulette = true;
    limited.contender.offset = "constant_epsilon", limited.contender.restart_carries_t = false;
    limited.convergence.seconds = {{1}, {1}, {1}, {1}};
    limited.convergence.relmse = {{-0.1}, {-0.1}, {-0.1}, {-0.1}};
    EXPECT_EQ(
        convergence_csv({}, results),
        kContender +
            "seeds,samples,seconds,lo_seconds,hi_seconds,relmse,lo_relmse,hi_relmse,rmse\r\n"
            "conference,mesh,12,10,cpu,restart,sort,watertight,waechter_binder,10,false,3,1,1.5,1,3,0.2,,,"
            "0.447214\r\n"
            "conference,mesh,12,10,cpu,restart,sort,watertight,waechter_binder,10,false,3,2,4,2,5,0.12,,,"
            "0.34641\r\n"
            "conference,mesh,12,10,cpu,restart_fresh_t,sort,watertight,constant_epsilon,2,true,4,1,1,1,1,"
            "-0.1,-0.1,-0.1,\r\n");
}

TEST(ConvergenceTable, FitsEachContenderThatIsSound) {
    Results results;
    CellResult& c = results.cells.emplace_back(cell());
    c.convergence.seconds = c.convergence.relmse = {{4, 2, 1}, {4, 2, 1}, {4, 2, 1}, {4, 2, 1}};
    c.convergence.bias = {0.5, 0.25, 0.75};
    results.cells.push_back(c);
    results.cells.back().valid = false;
    results.cells.push_back(cell());  // not measured before Ctrl-C
    EXPECT_EQ(convergence_fits_csv({}, results),
              kContender +
                  "slope,lo_slope,hi_slope,bias_relmse,lo_bias,hi_bias\r\n"
                  "conference,mesh,12,10,cpu,restart,sort,watertight,waechter_binder,10,false,-0.5,-0.5,-0.5,"
                  "0.5,0.25,0.75\r\n");
}

}  // namespace
}  // namespace ctpbench
