// scripts/plot on what a run leaves of what a ray costs as triangles grow.
#include "run_plot.h"

namespace ctpbench::test {
namespace {

const std::string kHeader = "scene,triangles,rays,contender,threads,ns_per_ray,lo_ns,hi_ns\n";
const std::string kGrowth = kHeader +
                            "grove_10k,10000,primary,ctp,2,40,38,42\n"
                            "grove,100000,primary,ctp,2,80,,\n"
                            "grove_10k,10000,bounce4,embree_default,1,100,90,120\n";

class PlotGrowth : public PlotTest {};

TEST_F(PlotGrowth, DrawsCostByTriangles) {
    write("growth.csv", kGrowth);
    const Outcome outcome = plot(".");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_EQ(outcome.output, "growth.svg\ngrowth.png\ngrowth_data.csv\n");
    expect_chart("growth");
    expect_words("growth", "primary, ctp, 2 threads, nanoseconds by triangles: 40.0 (10K), 80.0 (100K).");
    expect_words("growth", "bounce4, embree_default, 1 thread, nanoseconds by triangles: 100 (10K).");
    const auto data = read_csv(folder_ / "growth_data.csv");
    ASSERT_EQ(data.size(), 3u);
    EXPECT_EQ(data[2].at("hi_ns"), "120");
    expect_same_bytes_again({"growth"});
}

TEST_F(PlotGrowth, RefusesWhatHasNoPlaceOnTheAxes) {
    write("growth.csv", kHeader + "empty,0,primary,ctp,2,40,38,42\n");
    const Outcome outcome = plot(".");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.output.find("growth.csv:2: triangles"), std::string::npos) << outcome.output;
}

}  // namespace
}  // namespace ctpbench::test
