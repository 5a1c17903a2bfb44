#include "config/cells.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "names.h"

namespace ctpbench {
namespace {

std::vector<Cell> cells_of(const std::string& rest) {
    return expand(config_of("{\"schema_version\": 1, \"experiment\": \"e\", " + rest + "}"), test_names());
}

std::vector<std::string> names_of(const std::vector<Cell>& cells) {
    std::vector<std::string> names;
    for (const Cell& cell : cells) names.push_back(cell.name());
    return names;
}

using Names = std::vector<std::string>;

TEST(Cells, MultiplyOutInTheOrderWritten) {
    EXPECT_EQ(names_of(cells_of(
                  R"("matrix": {"strategy": ["oop", "ctp"], "spheres": [10, 1], "scene": ["b", "a"]})")),
              (Names{"b/10/cpu/oop/single/watertight", "b/10/cpu/ctp/single/watertight",
                     "b/1/cpu/oop/single/watertight", "b/1/cpu/ctp/single/watertight",
                     "a/10/cpu/oop/single/watertight", "a/10/cpu/ctp/single/watertight",
                     "a/1/cpu/oop/single/watertight", "a/1/cpu/ctp/single/watertight"}));
}

TEST(Cells, AxesThatMeanNothingCollapse) {
    EXPECT_EQ(names_of(cells_of(
                  R"("matrix": {"strategy": ["ctp", "restart"], "restart_carries_t": [true, false]})")),
              (Names{"smoke/1000/cpu/ctp/single/watertight", "smoke/1000/cpu/restart/single/watertight",
                     "smoke/1000/cpu/restart_fresh_t/single/watertight"}));
    EXPECT_EQ(names_of(cells_of(R"("matrix": {"spheres": [0, 5], "sphere_radius": [0.1, 0.5]})")),
              (Names{"smoke/0/cpu/ctp/single/watertight", "smoke/5/radius0.1/cpu/ctp/single/watertight",
                     "smoke/5/radius0.5/cpu/ctp/single/watertight"}));
    EXPECT_EQ(names_of(cells_of(
                  R"("matrix": {"strategy": ["ctp", "embree_robust"], "methods": ["watertight", "paper"],
                                              "traversal": ["single", "interleaved"]})")),
              (Names{"smoke/1000/cpu/ctp/single/watertight", "smoke/1000/cpu/ctp/single/paper",
                     "smoke/1000/cpu/ctp/interleaved/watertight", "smoke/1000/cpu/ctp/interleaved/paper",
                     "smoke/1000/cpu/embree_robust/own/own"}));
    EXPECT_EQ(names_of(cells_of(
                  R"("measure": false, "matrix": {"spheres": [0, 5], "builder": ["quality", "paper"]})")),
              (Names{"smoke/0", "smoke/0/paper_tree", "smoke/5", "smoke/5/paper_tree"}));
}

TEST(Cells, NamesTellNearRadiiApart) {
    EXPECT_EQ(cells_of(R"("matrix": {"sphere_radius": [0.1, 0.10000001]})").size(), 2u);
}

TEST(Cells, ExcludeNeedsEveryAxisToMatch) {
    const std::string matrix =
        R"("matrix": {"strategy": ["ctp", "restart"], "restart_carries_t": [true, false],
                                  "spheres": [0, 5]}, )";
    EXPECT_EQ(cells_of(matrix + "\"exclude\": []").size(), 6u);
    EXPECT_EQ(
        names_of(cells_of(matrix + R"("exclude": [{"strategy": "restart", "spheres": 0}])")),
        (Names{"smoke/0/cpu/ctp/single/watertight", "smoke/5/cpu/ctp/single/watertight",
               "smoke/5/cpu/restart/single/watertight", "smoke/5/cpu/restart_fresh_t/single/watertight"}));
    // ctp neither carries nor drops t, and without spheres there is no radius.
    EXPECT_EQ(cells_of(matrix + R"("exclude": [{"restart_carries_t": true}])").size(), 4u);
    EXPECT_EQ(cells_of(matrix + R"("exclude": [{"restart_carries_t": [true, false]}])").size(), 2u);
    EXPECT_EQ(cells_of(matrix + R"("exclude": [{"sphere_radius": 0.03}])").size(), 3u);
    EXPECT_EQ(cells_of(matrix + R"("exclude": [{"spheres": 5}, {"strategy": "restart"}])").size(), 1u);
    EXPECT_EQ(cells_of(matrix + R"("exclude": [{"scene": "elsewhere"}])").size(), 6u);
    EXPECT_EQ(
        cells_of(R"("matrix": {"strategy": ["ctp", "embree_robust"]}, "exclude": [{"methods": "paper"}])")
            .size(),
        2u);
}

TEST(Cells, IncludeAppendsWithDefaultsAndIsNotExcluded) {
    EXPECT_EQ(names_of(cells_of(R"("matrix": {"scene": ["a", "b"], "spheres": 7},
                                   "exclude": [{"scene": "b"}],
                                   "include": [{"scene": "b", "strategy": ["oop", "ctp"]}, {"scene": "b", "spheres": 7}])")),
              (Names{"a/7/cpu/ctp/single/watertight", "b/1000/cpu/oop/single/watertight",
                     "b/1000/cpu/ctp/single/watertight", "b/7/cpu/ctp/single/watertight"}));
    EXPECT_EQ(cells_of(R"("exclude": [{"scene": "smoke"}], "include": [{"scene": "b"}])").size(), 1u);
}

TEST(Cells, FilterKeepsWhatContainsTheText) {
    const std::vector<Cell> cells =
        cells_of(R"("matrix": {"scene": ["a", "b"], "strategy": ["ctp", "oop", "oop_arena"]})");
    EXPECT_EQ(filter(cells, "").size(), 6u);
    EXPECT_EQ(filter(cells, "oop").size(), 4u);
    EXPECT_EQ(filter(cells, "/oop/").size(), 2u);
    EXPECT_EQ(names_of(filter(cells, "b/1000/cpu/ctp")), Names{"b/1000/cpu/ctp/single/watertight"});
    try {
        filter(cells, "OOP");
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        EXPECT_STREQ(error.what(),
                     "--filter OOP: error: no cell's name contains this; names look like "
                     "a/1000/cpu/ctp/single/watertight, and --dry-run shows the cells");
    }
}

TEST(Cells, GroupByWorkloadKeepsTheOrder) {
    const auto groups = group_by_workload(cells_of(
        R"("matrix": {"scene": ["a", "b"], "strategy": ["ctp", "oop"]}, "include": [{"scene": "a", "strategy": "restart"}])"));
    ASSERT_EQ(groups.size(), 2u);
    EXPECT_EQ(groups[0].workload.name(), "a/1000");
    ASSERT_EQ(groups[0].contenders.size(), 3u);
    EXPECT_EQ(groups[0].contenders[2].strategy, "restart");
    EXPECT_EQ(groups[1].contenders.size(), 2u);
    const auto trees = group_by_workload(cells_of("\"measure\": false"));
    ASSERT_EQ(trees.size(), 1u);
    EXPECT_TRUE(trees[0].contenders.empty());
}

TEST(Cells, LabelsAreShortAndUnique) {
    const auto groups =
        group_by_workload(cells_of(R"("matrix": {"strategy": ["ctp", "restart", "embree_robust"],
        "restart_carries_t": [true, false], "methods": ["watertight", "paper"], "traversal": ["single", "interleaved"]})"));
    ASSERT_EQ(groups.size(), 1u);
    Names labels;
    for (const Contender& contender : groups[0].contenders) labels.push_back(contender.label());
    EXPECT_EQ(labels, (Names{"ctp", "ctp/paper", "ctp/interleaved", "ctp/interleaved/paper", "restart",
                             "restart/paper", "restart/interleaved", "restart/interleaved/paper",
                             "restart_fresh_t", "restart_fresh_t/paper", "restart_fresh_t/interleaved",
                             "restart_fresh_t/interleaved/paper", "embree_robust"}));
}

// A number of threads is a contender's own where it traces recorded rays on a CPU.
TEST(Cells, ThreadsTellContendersOfRaysApart) {
    const std::vector<Cell> cells = cells_of(R"("matrix": {"backend": ["cpu", "cuda"],
        "strategy": ["ctp", "embree_default"], "threads": [0, 1, 2]},
        "include": [{"strategy": "ctp", "shade": "ctp"}], "exclude": [{"strategy": "ctp", "threads": 2}])");
    Names labels;
    for (const Cell& cell : cells) labels.push_back(cell.contender->label());
    EXPECT_EQ(labels, (Names{"ctp", "ctp/1thread", "embree_default", "embree_default/1thread",
                             "embree_default/2threads", "ctp/cuda", "ctp+ctp"}));
    EXPECT_EQ(names_of(cells)[1], "smoke/1000/cpu/ctp/single/watertight/1thread");
    EXPECT_EQ(names_of(filter(cells, "/2threads")), Names{"smoke/1000/cpu/embree_default/own/own/2threads"});
    EXPECT_EQ(cells[1].contender->threads, 1u);
    EXPECT_EQ(cells[5].contender->threads, 0u) << "a device has none";
    EXPECT_NE(format_cells(cells).find("own    -       2\n"), std::string::npos) << format_cells(cells);
}

TEST(Cells, FormatAsATable) {
    EXPECT_EQ(
        format_cells(cells_of(R"("matrix": {"spheres": [0, 10000], "strategy": ["ctp", "embree_robust"]})")),
        "scene  spheres  sphere_radius  builder  backend  contender      traversal  methods     types  "
        "launch  threads\n"
        "smoke  0        -              quality  cpu      ctp            single     watertight  scene  -     "
        "  -\n"
        "smoke  0        -              quality  cpu      embree_robust  own        own         own    -     "
        "  -\n"
        "smoke  10000    0.03           quality  cpu      ctp            single     watertight  scene  -     "
        "  -\n"
        "smoke  10000    0.03           quality  cpu      embree_robust  own        own         own    -     "
        "  -\n");
}

// A yardstick is a cell on its own backend alone, and how kernels are launched concerns frames on a GPU
// alone.
TEST(Cells, KnowWhatBackendsHave) {
    const auto names = [](const std::string& matrix) {
        std::vector<std::string> all;
        for (const Cell& cell : cells_of(matrix)) all.push_back(cell.contender->label());
        return all;
    };
    EXPECT_EQ(
        names(
            R"("matrix": {"backend": ["cpu", "cuda"], "strategy": ["ctp", "embree_robust", "while_while"]})"),
        (std::vector<std::string>{"ctp", "embree_robust", "ctp/cuda", "while_while/cuda"}));
    EXPECT_EQ(names(R"("matrix": {"backend": ["cpu", "cuda"], "strategy": "restart", "shade": "ctp",
                       "launch": ["isolated", "graph"]})"),
              (std::vector<std::string>{"restart+ctp", "restart+ctp/cuda", "restart+ctp/cuda/graph"}));
}

}  // namespace
}  // namespace ctpbench
