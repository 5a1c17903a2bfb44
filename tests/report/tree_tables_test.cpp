#include "report/tree_tables.h"

#include <gtest/gtest.h>

#include <utility>

namespace ctpbench {
namespace {

Results results(const char* source = "mesh") {
    Results r;
    const Workload w{"conference", 1000, 0.03, "paper"};
    for (const auto& [kind, nodes] :
         {std::pair{"mixed", 266070}, {"triangles", 252000}, {"spheres", 700}, {"embree_robust", 0}}) {
        TreeResult t;
        t.workload = w, t.kind = kind, t.nodes = static_cast<std::size_t>(nodes);
        r.trees.push_back(t);
    }
    SceneResult scene;
    scene.name = "conference", scene.source = source, scene.triangles = 277552;
    r.scenes.push_back(scene);
    return r;
}

TEST(Table2, CountsTheCombinedTreeAndEachTypesOwn) {
    EXPECT_EQ(table2_csv(results()),
              "spheres,conference/paper/combined,conference/paper/triangles_alone,conference/paper/"
              "spheres_alone\r\n"
              "1000,266070,252000,700\r\n");
}

// The paper's tree of 253K nodes grew from 252K.
TEST(Table2, SetsThePapersGrowthBesideOurs) {
    const std::string text = table2_markdown(results());
    EXPECT_NE(text.find("| 1000 | 253 | 266.1 | 252.0 | 0.7 | 1.004 | 1.056 |"), std::string::npos) << text;
}

TEST(Table2, SetsNothingOfThePaperBesideAStandIn) {
    const std::string text = table2_markdown(results("stand-in"));
    EXPECT_NE(text.find("| 1000 | n/a | 266.1 | 252.0 | 0.7 | n/a | 1.056 |"), std::string::npos) << text;
}

}  // namespace
}  // namespace ctpbench
