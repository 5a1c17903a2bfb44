// scripts/plot on what the studies of types leave: narrowed kernels, and lists of ever more types.
#include "run_plot.h"

namespace ctpbench::test {
namespace {

const std::string kNarrowing =
    "scene,scene_source,triangles,spheres,backend,kernel,strategy,types,all_mrays_s,scene_mrays_s,gain,gain_"
    "lo,"
    "gain_hi,all_bytes,scene_bytes\n"
    "room,mesh,1200,0,cpu,intersect,ctp,triangle,10,11,1.1,1.08,1.12,48,36\n"
    "room,mesh,1200,0,cpu,intersect,oop,triangle,8,7.6,0.95,0.94,0.96,56,56\n"
    "room,mesh,1200,10,cpu,intersect,ctp,triangle+sphere,9,9,1,0.99,1.01,48,48\n"
    "room,mesh,1200,10,cpu,intersect,restart,triangle+sphere,9,,,,,48,48\n"
    "room,mesh,1200,0,cpu,shade,queues,\"matte+mirror, textured\",20,25,1.25,1.2,1.3,,\n";
const std::string kTypesHeader =
    "scene,scene_source,triangles,backend,kernel,strategy,listed,used,large,median_mrays_s,lo_mrays_s,"
    "hi_mrays_s,ratio,ratio_lo,ratio_hi\n";
// restart overtakes at 2 types, but not clearly so; oop at 4; std_variant is ahead, but not at the end.
const std::string kTypes = kTypesHeader +
                           "room,mesh,1200,cpu,intersect,ctp,1,1,none,20,20,20,1,1,1\n"
                           "room,mesh,1200,cpu,intersect,ctp,2,2,none,16,15,17,0.8,0.75,0.85\n"
                           "room,mesh,1200,cpu,intersect,ctp,4,4,none,10,9,11,0.5,0.45,0.55\n"
                           "room,mesh,1200,cpu,intersect,oop,1,1,none,12,11,13,0.6,0.55,0.65\n"
                           "room,mesh,1200,cpu,intersect,oop,2,2,none,12,11,13,0.6,0.55,0.65\n"
                           "room,mesh,1200,cpu,intersect,oop,4,4,none,12,11.2,13,0.6,0.56,0.65\n"
                           "room,mesh,1200,cpu,intersect,restart,1,1,none,18,17,19,0.9,0.85,0.95\n"
                           "room,mesh,1200,cpu,intersect,restart,2,2,none,17,16,18,0.85,0.8,0.9\n"
                           "room,mesh,1200,cpu,intersect,restart,4,4,none,16,15,17,0.8,0.75,0.85\n"
                           "room,mesh,1200,cpu,intersect,std_variant,2,2,none,18,17,19,0.9,0.87,0.95\n"
                           "room,mesh,1200,cpu,intersect,std_variant,4,4,none,8,7,9,0.4,0.35,0.45\n"
                           "room,mesh,1200,cpu,frame,ctp,1,1,none,5,4,6,1,1,1\n";
const std::string kSomeUsed = "room,mesh,1200,cpu,intersect,ctp,4,2,none,12,11,13,0.6,0.55,0.65\n";
const std::string kLarge =
    "room,mesh,1200,cpu,sort+shade+compact,queues,8,4,none,12,11,13,0.61,0.55,0.65\n"
    "room,mesh,1200,cpu,sort+shade+compact,queues,8,4,unused,12,11,13,0.59,0.55,0.65\n"
    "room,mesh,1200,cpu,sort+shade+compact,queues,8,4,used,,,,n/a,,\n";

class PlotTypes : public PlotTest {
protected:
    void expect_panel(const std::string& title, bool there) const {
        const bool found = read(folder_ / "types.svg").find("<!-- " + title + " -->") != std::string::npos;
        EXPECT_EQ(found, there) << title;
    }
};

TEST_F(PlotTypes, DrawsTheGainsOfNarrowedKernels) {
    write("narrowing.csv", kNarrowing);
    const Outcome outcome = plot(".");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_EQ(outcome.output, "narrowing.svg\nnarrowing.png\nnarrowing_data.csv\n");
    expect_chart("narrowing");
    expect_words(
        "narrowing",
        "room (mesh, 1.2K triangles), cpu, intersect, triangle, gain: ctp 1.10 [1.08, 1.12]; oop 0.950 "
        "[0.940, 0.960].");
    // What was not measured is not there.
    expect_words("narrowing", "10 spheres, cpu, intersect, triangle+sphere, gain: ctp 1.00 [0.990, 1.01].");
    expect_words("narrowing", "cpu, shade, matte+mirror, textured, gain: queues 1.25 [1.20, 1.30].");
    const auto data = read_csv(folder_ / "narrowing_data.csv");
    ASSERT_EQ(data.size(), 5u);
    EXPECT_EQ(data[0].at("gain_hi"), "1.12");
    EXPECT_EQ(data[0].at("scene_bytes"), "36");
    EXPECT_EQ(data[3].at("gain"), "");
    EXPECT_EQ(data[3].at("all_mrays_s"), "9");
    EXPECT_EQ(data[4].at("types"), "matte+mirror, textured");
}

TEST_F(PlotTypes, LeavesOutAKernelThatWasNotNarrowed) {
    write("narrowing.csv", kNarrowing.substr(0, kNarrowing.find("room,mesh,1200,0,cpu,shade")) +
                               "room,mesh,1200,0,cuda,intersect,ctp,triangle,90,99,1.1,1.08,1.12,48,36\n");
    ASSERT_EQ(plot(".").exit_code, 0);
    const std::string svg = read(folder_ / "narrowing.svg");
    for (const char* panel : {"<!-- intersect, cpu -->", "<!-- intersect, cuda -->"})
        EXPECT_NE(svg.find(panel), std::string::npos) << panel;
    EXPECT_EQ(svg.find("<!-- shade"), std::string::npos);
}

TEST_F(PlotTypes, DrawsRatiosByTheNumberOfTypes) {
    write("types.csv", kTypes + kSomeUsed + kLarge);
    const Outcome outcome = plot(".");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_EQ(outcome.output, "types.svg\ntypes.png\ntypes_data.csv\ntypes_crossovers.csv\n");
    expect_chart("types");
    expect_words("types",
                 "intersect, all listed types used, by types listed: ctp 1.00 (1), 0.800 (2), 0.500 (4); oop "
                 "0.600 (1)");
    expect_words("types", "intersect, 4 types listed, by types used: ctp 0.600 (2), 0.500 (4);");
    expect_words(
        "types",
        "sort+shade+compact, one type large, by large type in the list: queues 0.610 (4 of 8, none), "
        "0.590 (4 of 8, unused).");
    const auto data = read_csv(folder_ / "types_data.csv");
    ASSERT_EQ(data.size(), 16u);
    EXPECT_EQ(data[5].at("ratio_lo"), "0.56");
    EXPECT_EQ(data[11].at("kernel"), "frame");
    EXPECT_EQ(data[14].at("large"), "unused");
    EXPECT_EQ(data[15].at("ratio"), "n/a");
}

TEST_F(PlotTypes, LeavesOutPanelsOfWhatWasNotMeasured) {
    write("types.csv", kTypes + kLarge);
    ASSERT_EQ(plot(".").exit_code, 0);
    expect_panel("intersect, all listed types used", true);
    expect_panel("intersect, 4 types listed", false);
    expect_panel("intersect, one type large", false);
    expect_panel("sort+shade+compact, all listed types used", false);
    expect_panel("sort+shade+compact, one type large", true);
    write("types.csv", kTypes);
    ASSERT_EQ(plot(".").exit_code, 0);
    expect_panel("intersect, all listed types used", true);
    expect_panel("sort+shade+compact, one type large", false);
    EXPECT_EQ(read(folder_ / "types.svg").find("axes_2"), std::string::npos);
}

TEST_F(PlotTypes, FindsFromHowManyTypesOnAStrategyIsFaster) {
    write("types.csv", kTypes);
    ASSERT_EQ(plot(".").exit_code, 0);
    const auto table = read_csv(folder_ / "types_crossovers.csv");
    ASSERT_EQ(table.size(), 3u);
    const char* expected[][3] = {
        {"oop", "4", "true"}, {"restart", "2", "false"}, {"std_variant", "", "false"}};
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(table[i].at("kernel"), "intersect");
        EXPECT_EQ(table[i].at("strategy"), expected[i][0]);
        EXPECT_EQ(table[i].at("from_types"), expected[i][1]) << expected[i][0];
        EXPECT_EQ(table[i].at("clear"), expected[i][2]) << expected[i][0];
    }
    expect_words("types", "intersect: oop is faster than ctp from 4 types on, clearly.");
    expect_words("types", "intersect: restart is faster than ctp from 2 types on.");
    expect_words("types", "intersect: std_variant is faster than ctp at no number of types.");
}

TEST_F(PlotTypes, DrawsTheSameBytesAgain) {
    write("narrowing.csv", kNarrowing);
    write("types.csv", kTypes + kSomeUsed + kLarge);
    expect_same_bytes_again({"narrowing", "types"});
}

TEST_F(PlotTypes, RefusesNarrowedKernelsThatItCannotDraw) {
    const std::string at = "narrowing.csv:7: ", start = "room,mesh,1200,0,cpu,";
    write("narrowing.csv", kNarrowing + start + "sort,ctp,triangle,1,1,1,1,1,,\n");
    expect_refused(".", at + "unknown kernel \"sort\"; known are intersect, shade");
    write("narrowing.csv", kNarrowing + start + "intersect,restart,sphere,1,1,1,1,1,,\n");
    expect_refused(".", at + "types is \"sphere\", but \"triangle\" on a line above");
    write("narrowing.csv", kNarrowing + start + "intersect,restart,triangle,1,1,more,1,1,,\n");
    expect_refused(".", at + "gain is \"more\"; expected a number");
    write("narrowing.csv", kNarrowing + start + "intersect,restart,triangle,1,1,1,1,1,-4,\n");
    expect_refused(".", at + "all_bytes is \"-4\"; expected a number that is not negative");
    write("narrowing.csv", kNarrowing + start + "intersect,ctp,triangle,1,1,1,1,1,,\n");
    expect_refused(".", at + "a second row for room, 0, cpu, intersect, ctp");
    write("narrowing.csv", kNarrowing + start + "shade,ctp,matte+mirror, textured,1,1,1,1,1,,\n");
    expect_refused(".", at + "more fields than columns");
}

TEST_F(PlotTypes, RefusesNumbersOfTypesThatItCannotDraw) {
    const std::string at = "types.csv:14: ", start = "room,mesh,1200,cpu,";
    write("types.csv", kTypes + start + "sort,ctp,8,8,none,1,1,1,1,1,1\n");
    expect_refused(".",
                   at + "unknown kernel \"sort\"; known are intersect, sort+shade+compact, shade, frame");
    write("types.csv", kTypes + start + "shade,ctp,8,8,huge,1,1,1,1,1,1\n");
    expect_refused(".", at + "unknown large \"huge\"; known are none, unused, used");
    write("types.csv", kTypes + start + "shade,ctp,4,8,none,1,1,1,1,1,1\n");
    expect_refused(".", at + "used is 8, but only 4 types are listed");
    write("types.csv", kTypes + start + "shade,ctp,4,0,none,1,1,1,1,1,1\n");
    expect_refused(".", at + "used is \"0\"; expected a number of types");
    write("types.csv", kTypes + start + "shade,ctp,4.5,4,none,1,1,1,1,1,1\n");
    expect_refused(".", at + "listed is \"4.5\"; expected a number of types");
    write("types.csv", kTypes + start + "shade,ctp,8,8,none,1,1,1,nan,1,1\n");
    expect_refused(".", at + "ratio is \"nan\"; expected a number");
    write("types.csv", kTypes + start + "intersect,oop,4,4,none,1,1,1,1,1,1\n");
    expect_refused(".", at + "a second row for room, cpu, intersect, oop, 4, 4, none");
    write("types.csv", kTypesHeader + start + "frame,ctp,1,1,none,1,1,1,1,1,1\n");
    expect_refused(".", "types.csv: no ratio of intersect or sort+shade+compact");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "types.svg"));
}

}  // namespace
}  // namespace ctpbench::test
