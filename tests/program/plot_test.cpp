// scripts/plot on small runs: the files that it leaves, the figures that they hold, and what it refuses.
#include "run_plot.h"

namespace ctpbench::test {
namespace {

const char* kFigure4 =
    "scene,scene_source,triangles,spheres,backend,strategy,kernel,seconds,lo_seconds,hi_seconds,rays,bounces,"
    "width,height\n"
    "room,mesh,1200,0,cpu,ctp,intersect,4,3.9,4.1,5000,10,64,32\n"
    "room,mesh,1200,0,cpu,ctp,shade,0.5,0.4,0.6,5000,10,64,32\n"
    "room,mesh,1200,0,cpu,sort,intersect,3,2.9,3.1,5000,10,64,32\n"
    "room,mesh,1200,0,cpu,sort,sort,0.25,0.2,0.3,5000,10,64,32\n";
const char* kTable1 =
    "kernel,room/cpu/ctp,room/cpu/sort\n"
    "intersect,1.234,1.5\n"
    "sort,n/a,45\n";
const char* kTable3 =
    "spheres,room/cpu/ctp,room/cpu/restart\n"
    "10,1.5,1.2\n"
    "1000,1.25,n/a\n";
const char* kSummary =
    "scene,scene_source,triangles,spheres,backend,strategy,shade,kernel,median_mrays_s,lo_mrays_s,hi_mrays_"
    "s\n"
    "room,stand-in,1200,0,cpu,ctp,ctp,intersect,1.23441,1.2,1.3\n"
    "room,stand-in,1200,0,cpu,ctp,sort,intersect,1.5,1.4,1.6\n"
    "room,stand-in,1200,10,cpu,ctp,,intersect,1.50001,1.45,1.55\n";

using Plot = PlotTest;

TEST_F(Plot, DrawsFigure4WithItsDataAndWords) {
    write("figure4.csv", kFigure4);
    const Outcome outcome = plot(".");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_EQ(outcome.output, "figure4.svg\nfigure4.png\nfigure4_data.csv\n");
    expect_chart("figure4");
    const auto data = read_csv(folder_ / "figure4_data.csv");
    ASSERT_EQ(data.size(), 4u);
    EXPECT_EQ(data[3].at("kernel"), "sort");
    EXPECT_EQ(data[3].at("seconds"), "0.25");
    EXPECT_EQ(data[3].at("hi_seconds"), "0.3");
    expect_words("figure4", "ctp 4.50 s, of which shade 0.500; sort 3.25 s, of which shade 0.00.");
}

TEST_F(Plot, TakesTheIntervalsOfTable1FromTheSummary) {
    write("table1.csv", kTable1);
    write("summary.csv", kSummary);
    const Outcome outcome = plot(". --out charts/here");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    expect_chart("charts/here/table1");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "table1.svg"));
    const auto data = read_csv(folder_ / "charts/here/table1_data.csv");
    ASSERT_EQ(data.size(), 4u);
    EXPECT_EQ(data[0].at("mrays_s"), "1.234");
    EXPECT_EQ(data[0].at("lo_mrays_s"), "1.2");
    EXPECT_EQ(data[1].at("strategy"), "sort");
    EXPECT_EQ(data[1].at("hi_mrays_s"), "1.6");
    EXPECT_EQ(data[2].at("mrays_s"), "n/a");
    EXPECT_EQ(data[3].at("mrays_s"), "45.0");
    EXPECT_EQ(data[3].at("lo_mrays_s"), "");
}

TEST_F(Plot, DrawsTable3WithAndWithoutASummary) {
    write("table3.csv", kTable3);
    ASSERT_EQ(plot(".").exit_code, 0);
    expect_chart("table3");
    EXPECT_EQ(read_csv(folder_ / "table3_data.csv").at(0).at("lo_mrays_s"), "");
    write("summary.csv", kSummary);
    ASSERT_EQ(plot(".").exit_code, 0);
    const auto data = read_csv(folder_ / "table3_data.csv");
    ASSERT_EQ(data.size(), 4u);
    EXPECT_EQ(data[0].at("spheres"), "10");
    EXPECT_EQ(data[0].at("lo_mrays_s"), "1.45");
    EXPECT_EQ(data[3].at("strategy"), "restart");
    EXPECT_EQ(data[3].at("mrays_s"), "n/a");
}

// Colours and hatches begin again after nine; no pair of them does.
TEST_F(Plot, TellsManyStrategiesApart) {
    std::string names = "spheres", values = "10";
    for (char c = 'a'; c < 'a' + 18; ++c) names += std::string(",room/cpu/") + c, values += ",1";
    write("table3.csv", names + "\n" + values + "\n");
    ASSERT_EQ(plot(".").exit_code, 0);
    const std::string svg = read(folder_ / "table3.svg");
    int patterns = 0;
    for (std::size_t at = 0; (at = svg.find("<pattern", at)) != std::string::npos; ++at) ++patterns;
    EXPECT_EQ(patterns, 16);  // two are plain
}

TEST_F(Plot, DrawsWhereCyclesGo) {
    write("profile.csv",
          "scene,spheres,bounce,isa,rays,phase,per_ray,cycles_each,cycles_per_ray,rays_per_loop\n"
          "room,0,0,avx2,64,packets,1,90,90,21\n"
          "room,0,0,avx2,64,nodes,0.5,20,10,21\n"
          "room,2000,1,avx2,64,packets,0,,4,0\n"
          "room,2000,1,avx2,64,nodes,6,20,120,21\n");
    const Outcome outcome = plot(".");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    expect_chart("profile");
    expect_words("profile", "camera rays: 100 cycles a ray, of which packets 90.0, nodes 10.0.");
    expect_words("profile", "2K spheres, bounce 1: 124 cycles a ray, of which packets 4.00, nodes 120.");
}

TEST_F(Plot, DrawsTheSameBytesAgain) {
    write("figure4.csv", kFigure4);
    write("table1.csv", kTable1);
    write("table3.csv", kTable3);
    expect_same_bytes_again({"figure4", "table1", "table3"});
}

TEST_F(Plot, RefusesWhatItCannotDraw) {
    expect_refused("", "RESULTS_DIR");
    expect_refused("nowhere", "nowhere: no such folder");
    expect_refused(".", "holds none of figure4.csv, table1.csv, table3.csv");
    write("table3.csv", "");
    expect_refused(".", "table3.csv: no column spheres");
    write("table3.csv", "spheres,room/cpu/ctp\n");
    expect_refused(".", "table3.csv: holds no rows");
    write("table3.csv", "spheres,ctp\n10,1\n");
    expect_refused(".", "table3.csv: column \"ctp\"; expected SCENE/BACKEND/STRATEGY");
    write("table3.csv", "spheres,room/cpu/ctp\n10,fast\n");
    expect_refused(".", "table3.csv:2: room/cpu/ctp is \"fast\"");
    write("table3.csv", "spheres,room/cpu/ctp\n10,1,2\n");
    expect_refused(".", "table3.csv:2: more fields than columns");
    write("table3.csv", "spheres,room/cpu/ctp\n10\n");
    expect_refused(".", "table3.csv:2: fewer fields than columns");
    write("table3.csv", kTable3);
    write("figure4.csv", std::string(kFigure4) + "room,mesh,1200,0,cpu,ctp,generate,1,1,1,5000,10,64,32\n");
    expect_refused(".", "figure4.csv:6: unknown kernel \"generate\"");
    write("figure4.csv", std::string(kFigure4) + "room,mesh,1200,0,cpu,ctp,shade,1,1,1,5000,10,64,32\n");
    expect_refused(".", "figure4.csv:6: a second row");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "table3.svg"));  // nothing is drawn unless all can be
}

TEST_F(Plot, SaysWhereItCannotWrite) {
    write("table3.csv", kTable3);
    const Outcome outcome = plot(". --out table3.csv/charts");
    EXPECT_EQ(outcome.exit_code, 8) << outcome.output;
    EXPECT_NE(outcome.output.find("name another folder with --out"), std::string::npos) << outcome.output;
}

}  // namespace
}  // namespace ctpbench::test
