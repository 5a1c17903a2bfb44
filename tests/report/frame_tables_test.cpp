#include "report/frame_tables.h"

#include <gtest/gtest.h>

namespace ctpbench {
namespace {

CellResult cell(const std::string& scene, const std::string& shade) {
    CellResult c;
    c.workload = {scene, 0, 0.03, "quality"};
    c.contender = {"cpu", "restart", true, "single", "watertight", shade};
    c.scene_source = "mesh", c.triangles = 12;
    c.checked = c.valid = true;
    return c;
}

// Two rounds; `shade` Mrays/s of shading, all else alike.
Results results() {
    Results r;
    for (const auto& [shade, speed] :
         std::vector<std::pair<const char*, double>>{{"ctp", 30}, {"oop", 20}, {"sort", 15}}) {
        CellResult& c = r.cells.emplace_back(cell("conference", shade));
        for (const double slow : {1.0, 2.0}) {
            c.add("intersect", 1000, 4 / slow, 0.25 * slow);
            c.add("copy", 1000, 4000 / slow, 0.00025 * slow);
            if (c.contender.shade == "sort") c.add("sort", 1000, 1000 / slow, 0.001 * slow);
            c.add("shade", 1000, speed / slow, slow / speed);
            c.add("compact", 1000, 2000 / slow, 0.0005 * slow);
        }
    }
    // What only intersects is no part of these tables.
    CellResult intersects = cell("conference", "none");
    intersects.add("intersect", 1000, 9, 0.1);
    r.cells.push_back(intersects);
    return r;
}

TEST(Table1, HasARowPerKernelAndAColumnPerStrategy) {
    EXPECT_EQ(table1_csv(results()),
              "kernel,conference/cpu/ctp,conference/cpu/oop,conference/cpu/sort\r\n"
              "intersect,3,3,3\r\n"
              "sort,n/a,n/a,750\r\n"
              "shade,22.5,15,11.25\r\n"
              "compact,1500,1500,1500\r\n");
}

TEST(Table1, SetsThePapersRatiosBesideOurs) {
    const std::string text = table1_markdown(results());
    // Paired within rounds: ratios are sharp however slow a round was.
    EXPECT_NE(
        text.find("| shade | 31.60 | 30.40 | 22.60 | 22.50 | 15.00 | 11.25 | 1.04 | 1.50 [1.50, 1.50] | "
                  "1.40 | 2.00 [2.00, 2.00] |"),
        std::string::npos)
        << text;
    EXPECT_NE(text.find("| sort | n/a | n/a | 45.40 |"), std::string::npos) << text;
    EXPECT_NE(text.find("| sort: sort | 750 | 3000 | 0.25 [0.25, 0.25] |"), std::string::npos) << text;
    EXPECT_NE(text.find("| ctp | 1.00 [1.00, 1.00] | 0.426 | 0.13 [0.13, 0.13] | 0.0 |"), std::string::npos)
        << text;
}

TEST(Table1, LeavesRejectedContendersOut) {
    Results r = results();
    r.cells[1].valid = false;
    EXPECT_EQ(table1_csv(r).find("15,"), std::string::npos);
    EXPECT_NE(table1_csv(r).find("shade,22.5,n/a,11.25\r\n"), std::string::npos) << table1_csv(r);
}

// A stand-in's figures are never set beside the paper's.
TEST(Table1, ComparesMeshesOnlyWithThePaper) {
    Results r = results();
    for (CellResult& c : r.cells) c.scene_source = "stand-in";
    EXPECT_EQ(table1_markdown(r).find("31.60"), std::string::npos);
}

TEST(Figure4, HasALinePerStrategyAndKernel) {
    Config config;
    config.width = 64, config.height = 32;
    const std::string csv = figure4_csv(config, results());
    EXPECT_NE(csv.find("conference,mesh,12,0,cpu,sort,sort,0.0015,0.001,0.002,1000,10,64,32\r\n"),
              std::string::npos)
        << csv;
    EXPECT_EQ(csv.find("copy"), std::string::npos) << "the yardstick is no part of a frame";
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 3 + 3 + 4);
}

}  // namespace
}  // namespace ctpbench
