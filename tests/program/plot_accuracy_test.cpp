// scripts/plot on what the studies of accuracy leave: the figures in its charts, and what it refuses.
#include "run_plot.h"

namespace ctpbench::test {
namespace {

const char* kStability =
    "kind,method,is_default,workload,rays,failures,failures_per_million,lo,hi,p99_scaled_error,backend\n"
    "triangle,moeller_trumbore,false,edges,1000000,110000,110000,109000,111000,9,cpu\n"
    "triangle,moeller_trumbore,false,needles,500000,900,1800,1700,1900,9,cpu\n"
    "triangle,watertight,true,edges,1000000,0,0,0,3,2,cpu\n"
    "triangle,watertight,true,needles,0,0,,,,,cpu\n"
    "sphere,stable,true,distance_1e2,1000000,72,72,56,91,0.6,cpu\n";
const char* kPareto =
    "scene,scene_source,triangles,spheres,backend,methods,triangle_test,sphere_test,box_test,median_mrays_s,"
    "lo_mrays_s,hi_mrays_s,rays,failures,failures_per_million,lo,hi,p99_scaled_error,on_front\n"
    "room,mesh,1200,10,cpu,watertight,bundle,bundle,bundle,8,7.5,8.5,1000000,0,0,0,3,2,true\n"
    "room,mesh,1200,10,cpu,watertight,pluecker,bundle,bundle,7,6.5,7.5,1000000,4900,4900,4700,5100,2,false\n"
    "room,mesh,1200,10,cpu,watertight,moeller_trumbore,bundle,plain,10,9,11,1000000,110000,110000,109000,"
    "111000,0,true\n";
const std::string kConvergenceContender =
    "scene,scene_source,triangles,spheres,backend,strategy,shade,methods,offset,bounces,roulette,";
const std::string kConvergence =
    kConvergenceContender + "seeds,samples,seconds,lo_seconds,hi_seconds,relmse,lo_relmse,hi_relmse,rmse\n" +
    "room,mesh,1200,0,cpu,ctp,ctp,watertight,waechter_binder,10,false,8,1,0.1,0.09,0.11,0.4,0.3,0.5,0.63\n"
    "room,mesh,1200,0,cpu,ctp,ctp,watertight,waechter_binder,10,false,8,2,0.2,0.19,0.21,0.2,0.1,0.3,0.45\n"
    "room,mesh,1200,0,cpu,ctp,sort,watertight,waechter_binder,10,false,8,1,0.3,0.29,0.31,0.4,0.3,0.5,0.63\n"
    "room,mesh,1200,0,cpu,ctp,ctp,watertight,waechter_binder,2,false,8,1,0.05,0.04,0.06,0.5,0.4,0.6,0.71\n"
    "room,mesh,1200,0,cpu,ctp,ctp,watertight,waechter_binder,10,true,8,1,0.05,,,-0.01,-0.3,0.6,\n";
const std::string kFits =
    kConvergenceContender + "slope,lo_slope,hi_slope,bias_relmse,lo_bias,hi_bias\n" +
    "room,mesh,1200,0,cpu,ctp,ctp,watertight,waechter_binder,10,false,-0.5,-0.51,-0.49,1e-5,-2e-5,4e-5\n"
    "room,mesh,1200,0,cpu,ctp,ctp,watertight,waechter_binder,2,false,-0.2,-0.3,-0.1,0.04,0.03,0.05\n";

using PlotAccuracy = PlotTest;

TEST_F(PlotAccuracy, DrawsStabilityAsCountsPerMillion) {
    write("stability.csv", kStability);
    const Outcome outcome = plot(".");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    expect_chart("stability");
    expect_words("stability", "triangle moeller_trumbore: edges 110k, needles 1.8k.");
    expect_words("stability", "triangle watertight *: edges 0. sphere stable *: distance_1e2 72.");
    const auto data = read_csv(folder_ / "stability_data.csv");
    ASSERT_EQ(data.size(), 5u);
    EXPECT_EQ(data[1].at("failures"), "900");
    EXPECT_EQ(data[2].at("hi"), "3");
    EXPECT_EQ(data[3].at("failures_per_million"), "");
}

TEST_F(PlotAccuracy, NamesBackendsWhereThereAreSeveral) {
    write("stability.csv", std::string(kStability) +
                               "triangle,watertight,true,edges,1000000,11500,11500,11300,11700,2,cuda\n");
    ASSERT_EQ(plot(".").exit_code, 0);
    expect_words("stability", "triangle watertight, cpu *: edges 0.");
    expect_words("stability", "triangle watertight, cuda *: edges 12k.");
}

TEST_F(PlotAccuracy, DrawsTheParetoFront) {
    write("pareto.csv", kPareto);
    const Outcome outcome = plot(".");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    expect_chart("pareto");
    // The bundle's own tests need no name.
    expect_words("pareto",
                 "room (mesh, 1.2K triangles), 10 spheres, cpu, on the front, with failures per million: "
                 "watertight 8.00 Mrays/s with 0; moeller_trumbore / plain 10.0 Mrays/s with 110k.");
    const auto data = read_csv(folder_ / "pareto_data.csv");
    ASSERT_EQ(data.size(), 3u);
    EXPECT_EQ(data[1].at("on_front"), "false");
    EXPECT_EQ(data[1].at("failures_per_million"), "4900");
}

TEST_F(PlotAccuracy, DrawsConvergenceWithSlopesAndPlateaus) {
    write("convergence.csv", kConvergence);
    write("convergence_fits.csv", kFits);
    const Outcome outcome = plot(".");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    expect_chart("convergence");
    expect_words("convergence",
                 "waechter_binder, 10 bounces: relMSE 0.2 after 2 samples; slope \u22120.500 [\u22120.510, "
                 "\u22120.490].");
    // A bias is a plateau where its interval excludes none.
    expect_words("convergence",
                 "2 bounces: relMSE 0.5 after 1 samples; slope \u22120.200 [\u22120.300, "
                 "\u22120.100]; plateau 0.04 (20 %) [0.03, 0.05].");
    expect_words("convergence", "10 bounces, roulette: relMSE -0.01 after 1 samples; no fit.");
    for (const char* panel : {"strategies", "bounce limits and roulette"})
        EXPECT_NE(read(folder_ / "convergence.svg").find(panel), std::string::npos) << panel;
    EXPECT_EQ(read(folder_ / "convergence.svg").find("offsets"), std::string::npos);
    const auto data = read_csv(folder_ / "convergence_data.csv");
    ASSERT_EQ(data.size(), 5u);
    EXPECT_EQ(data[1].at("relmse"), "0.2");
    EXPECT_EQ(data[1].at("slope"), "-0.5");
    EXPECT_EQ(data[3].at("bias_relmse"), "0.04");
    EXPECT_EQ(data[4].at("slope"), "");
}

TEST_F(PlotAccuracy, DrawsTheSameBytesAgain) {
    write("stability.csv", kStability);
    write("pareto.csv", kPareto);
    write("convergence.csv", kConvergence);
    expect_same_bytes_again({"stability", "pareto", "convergence"});
}

TEST_F(PlotAccuracy, RefusesWhatItCannotDraw) {
    write("stability.csv", std::string(kStability) + "box,plain,perhaps,cube,10,1,1,1,1,1,cpu\n");
    expect_refused(".", "stability.csv:7: is_default is \"perhaps\"; expected true or false");
    write("stability.csv", std::string(kStability) + "box,plain,false,cube,10,,1,1,1,1,cpu\n");
    expect_refused(".", "stability.csv:7: failures is empty");
    write("stability.csv", std::string(kStability) + "sphere,stable,true,distance_1e2,1,0,0,0,3,2,cpu\n");
    expect_refused(".", "stability.csv:7: a second row for sphere, stable, cpu, distance_1e2");
    write("stability.csv", kStability);
    write("pareto.csv", std::string(kPareto) + "room,mesh,9,0,cpu,a,b,c,d,0,0,0,1,-1,0,0,3,2,true\n");
    expect_refused(".", "pareto.csv:5: failures is \"-1\"; expected a number that is not negative");
    write("pareto.csv", std::string(kPareto) + "room,mesh,9,0,cpu,a,b,c,d,0,0,0,0,0,,,,2,true\n");
    expect_refused(".", "pareto.csv:5: rays is 0");
    write("pareto.csv", kPareto);
    write("convergence.csv", kConvergence);
    write("convergence_fits.csv",
          kFits + "hall,mesh,1200,0,cpu,ctp,ctp,watertight,waechter_binder,10,false,-0.5,,,0,0,0\n");
    expect_refused(".", "convergence_fits.csv:4: no such contender in convergence.csv");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "stability.svg"));  // nothing unless all can be
}

}  // namespace
}  // namespace ctpbench::test
