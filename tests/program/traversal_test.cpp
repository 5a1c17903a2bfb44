// Traversals in whole runs: hits and images are the same whatever the traversal and the instruction set.
#include <nlohmann/json.hpp>
#include <set>

#include "run_program.h"
#include "wavefront/interleaved/isa.h"

namespace ctpbench::test {
namespace {

class Traversal : public ProgramTest {
protected:
    // Intersects and renders; `more` goes into the matrix.
    void write_config(const std::string& more) {
        write("c.json", R"({"schema_version": 1, "experiment": "x", "width": 48, "height": 40, "bounces": 4,
            "rounds": 1, "matrix": {"scene": "smoke", "spheres": 60, )" +
                            more + "}}");
    }
};

TEST_F(Traversal, RendersTheSameImagesAndFindsTheSameHits) {
    write_config(R"("strategy": ["ctp", "oop", "restart", "typed_phases"],
        "traversal": ["single", "interleaved"], "shade": ["none", "ctp", "sort", "queues"])");
    std::set<std::string> images, traversals;
    std::map<std::string, std::set<std::string>> hits;
    for (const std::string& isa : usable_isas()) {
        const Outcome outcome = run("--quiet --config $D/c.json --out $D/" + isa + " --isa " + isa);
        ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
        for (const auto& row : read_csv(folder_ / isa / "rows.csv")) {
            traversals.insert(row.at("strategy") + "/" + row.at("traversal"));
            if (row.at("shade") == "none")
                hits[row.at("bounce")].insert(row.at("hit_hash"));
            else if (!row.at("image_hash").empty())
                images.insert(row.at("image_hash"));
        }
        const auto meta = nlohmann::json::parse(read(folder_ / isa / "meta.json"));
        EXPECT_EQ(meta.at("isa"), isa);
    }
    EXPECT_EQ(traversals,
              (std::set<std::string>{"ctp/single", "ctp/interleaved", "oop/single", "oop/interleaved",
                                     "restart/single", "restart/interleaved", "typed_phases/interleaved"}));
    EXPECT_EQ(images.size(), 1u);
    EXPECT_EQ(hits.size(), 5u);
    for (const auto& [bounce, hashes] : hits) EXPECT_EQ(hashes.size(), 1u) << bounce;
}

TEST_F(Traversal, SaysWhatItIsNotBuiltFor) {
    write_config(R"("traversal": "interleaved", "methods": "paper")");
    Outcome outcome = run("--config $D/c.json --out $D/r");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.output.find("traversal \"interleaved\" is built for methods \"watertight\" alone"),
              std::string::npos)
        << outcome.output;
    write_config(R"("traversal": "interleaved")");
    outcome = run("--config $D/c.json --out $D/r --isa sse9");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.output.find("--isa"), std::string::npos) << outcome.output;
}

}  // namespace
}  // namespace ctpbench::test
