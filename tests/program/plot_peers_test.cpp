// scripts/plot on what a run leaves that compares us with Embree.
#include "run_plot.h"

namespace ctpbench::test {
namespace {

const std::string kHeader =
    "scene,rays,contender,threads,median_mrays_s,ratio_to_rtcintersect1,ratio_lo,ratio_hi,mismatch_rate\n";
const std::string kPeers = kHeader +
                           "room,primary,ctp,1,3,0.5,0.48,0.52,0\n"
                           "room,primary,ctp,2,6,0.6,0.55,0.65,0\n"
                           "room,primary,embree_default,1,6,1,1,1,2e-06\n"
                           "room,primary,embree_default,2,10,1,1,1,5e-06\n"
                           "room,primary,embree_robust,1,5,0.83,0.8,0.85,0\n"
                           "room,bounce4,ctp,1,2,0.8,0.7,0.9,0\n"
                           "room,bounce4,embree_default,1,2.5,1,1,1,0\n"
                           "hall/10,primary,ctp/interleaved,2,9,,,,\n"
                           "hall/10,primary,embree_stream_coherent,2,9,4.5,4.4,4.6,\n";

class PlotPeers : public PlotTest {
protected:
    void expect_panel(const std::string& title, bool there) const {
        const bool found = read(folder_ / "peers.svg").find("<!-- " + title + " -->") != std::string::npos;
        EXPECT_EQ(found, there) << title;
    }
};

TEST_F(PlotPeers, DrawsRatiosByThreads) {
    write("peers.csv", kPeers);
    write("summary.csv",
          "scene,scene_source,triangles,backend,strategy,kernel,median_mrays_s,lo_mrays_s,hi_mrays_s\n"
          "room,mesh,1200,cpu,ctp,intersect,1,1,1\n");
    const Outcome outcome = plot(".");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_EQ(outcome.output, "peers.svg\npeers.png\npeers_data.csv\n");
    expect_chart("peers");
    expect_panel("room, primary", true);
    expect_panel("room, bounce4", true);
    expect_panel("hall/10, primary", true);
    expect_panel("hall/10, bounce4", false);
    expect_words(
        "peers",
        "room (mesh, 1.2K triangles), primary, ratio to rtcIntersect1, by threads: ctp 0.500 [0.480, "
        "0.520] (1), 0.600 [0.550, 0.650] (2); embree_default 1.00 [1.00, 1.00] (1), 1.00 [1.00, 1.00] "
        "(2), 5.00 mismatches per million; embree_robust 0.830 [0.800, 0.850] (1).");
    // What has no ratio is not there.
    expect_words("peers",
                 "hall/10, primary, ratio to rtcIntersect1, by threads: embree_stream_coherent 4.50");
    EXPECT_EQ(read(folder_ / "peers.svg").find("<!-- ctp/interleaved -->"), std::string::npos);
    const auto data = read_csv(folder_ / "peers_data.csv");
    ASSERT_EQ(data.size(), 9u);
    EXPECT_EQ(data[1].at("ratio_hi"), "0.65");
    EXPECT_EQ(data[3].at("mismatch_rate"), "5e-06");
    EXPECT_EQ(data[7].at("ratio_lo"), "");
}

TEST_F(PlotPeers, DrawsTheSameBytesAgain) {
    write("peers.csv", kPeers);
    expect_same_bytes_again({"peers"});
}

TEST_F(PlotPeers, RefusesWhatItCannotDraw) {
    const std::string at = "peers.csv:11: ", start = "room,primary,oop,";
    write("peers.csv", kPeers + start + "0,1,1,1,1,0\n");
    expect_refused(".", at + "threads is \"0\"; expected a number of threads, 1 or more");
    write("peers.csv", kPeers + start + "1.5,1,1,1,1,0\n");
    expect_refused(".", at + "threads is \"1.5\"; expected a number of threads");
    write("peers.csv", kPeers + start + "1,,1,1,1,0\n");
    expect_refused(".", at + "median_mrays_s is empty");
    write("peers.csv", kPeers + start + "1,1,fast,1,1,0\n");
    expect_refused(".", at + "ratio_to_rtcintersect1 is \"fast\"; expected a number");
    write("peers.csv", kPeers + start + "1,1,0,0,1,0\n");
    expect_refused(".", at + "ratio_to_rtcintersect1 is \"0\"; expected more than 0");
    write("peers.csv", kPeers + start + "1,1,1,1,1,-1\n");
    expect_refused(".", at + "mismatch_rate is \"-1\"; expected a number that is not negative");
    write("peers.csv", kPeers + "room,primary,ctp,2,1,1,1,1,0\n");
    expect_refused(".", at + "a second row for room, primary, ctp, 2");
    write("peers.csv", kHeader + "room,primary,ctp,1,3,,,,0\n");
    expect_refused(".", "peers.csv: no ratio to rtcIntersect1; measure embree_default too");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "peers.svg"));
}

}  // namespace
}  // namespace ctpbench::test
