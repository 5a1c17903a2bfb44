// Our traversals beside Embree's through the whole program: peers.csv, threads of contenders, chosen bounces.
#include <gtest/gtest.h>

#include <set>

#include "run_program.h"

namespace ctpbench::test {
namespace {

class PeersRun : public ProgramTest {
protected:
    Outcome run_config(const std::string& body) {
        write("p.json",
              "{\"schema_version\": 1, \"experiment\": \"p\", \"width\": 61, \"height\": 33, \"bounces\": 2, "
              "\"rounds\": 2, \"batch_rays\": 0,\n" +
                  body + "}");
        std::filesystem::remove_all(folder_ / "r");
        return run("--quiet --config $D/p.json --out $D/r");
    }
};

// 61 x 33 rays are no multiple of 16.
TEST_F(PeersRun, SetEveryoneBesideIntersect1) {
    const Outcome outcome = run_config(R"("matrix": {"scene": "smoke", "spheres": 200, "threads": [0, 1],
        "strategy": ["ctp", "typed_leaves", "embree_default", "embree_robust", "embree_16", "embree_16_robust",
            "embree_16_coherent", "embree_16_coherent_robust", "embree_stream", "embree_stream_robust",
            "embree_stream_coherent", "embree_stream_coherent_robust"]},
        "threads": 1, "batch_bounces": [2, 0], "tables": ["peers"])");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    const std::string text = read(folder_ / "r/peers.csv");
    EXPECT_EQ(text.substr(0, text.find("\r\n")),
              "scene,rays,contender,threads,median_mrays_s,ratio_to_rtcintersect1,ratio_lo,ratio_hi,"
              "mismatch_rate");
    std::map<std::string, std::set<std::string>> classes, hashes;
    for (const auto& row : read_csv(folder_ / "r/peers.csv")) {
        EXPECT_EQ(row.at("scene"), "smoke/200");
        EXPECT_EQ(row.at("threads"), "1");
        EXPECT_GT(std::stod(row.at("median_mrays_s")), 0.0);
        classes[row.at("contender")].insert(row.at("rays"));
        const bool ours = row.at("contender").find("embree") == std::string::npos;
        EXPECT_LE(std::stod(row.at("mismatch_rate")), ours ? 0.0 : 0.01) << row.at("contender");
        const bool itself = row.at("contender") == "embree_default";
        for (const char* column : {"ratio_to_rtcintersect1", "ratio_lo", "ratio_hi"}) {
            if (itself) {
                EXPECT_EQ(row.at(column), "1");
            }
#ifdef CTPBENCH_EMBREE
            EXPECT_GT(std::stod(row.at(column)), 0.0);
#endif
        }
    }
    for (const auto& [contender, rays] : classes)
        EXPECT_EQ(rays, (std::set<std::string>{"primary", "bounce2"})) << contender;
#ifdef CTPBENCH_EMBREE
    EXPECT_EQ(classes.size(), CTPBENCH_EMBREE == 3 ? 12u : 8u);
#else
    EXPECT_EQ(classes.size(), 2u);
#endif
    for (const auto& row : read_csv(folder_ / "r/rows.csv")) {
        EXPECT_EQ(row.at("threads"), "1");
        EXPECT_TRUE(row.at("bounce") == "0" || row.at("bounce") == "2");
        if (row.at("methods") == "watertight") hashes[row.at("bounce")].insert(row.at("hit_hash"));
    }
    ASSERT_EQ(hashes.size(), 2u);
    for (const auto& [bounce, distinct] : hashes) EXPECT_EQ(distinct.size(), 1u) << bounce;
    // The robust tree serves the oracle and every call; the other one every other call.
    std::size_t embrees = 0;
    for (const auto& row : read_csv(folder_ / "r/trees.csv")) embrees += row.at("tree").starts_with("embree");
#ifdef CTPBENCH_EMBREE
    EXPECT_EQ(embrees, 2u);
#endif
}

TEST_F(PeersRun, ThreadsThatTheMachineHasNotAreLeftOut) {
    const Outcome outcome = run_config(R"("matrix": {"scene": "smoke", "spheres": 0, "strategy": "ctp",
        "threads": [1, 1024]})");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_NE(read(folder_ / "r/meta.json").find("ctp/1024threads: left out, this machine allows "),
              std::string::npos);
    for (const auto& row : read_csv(folder_ / "r/rows.csv")) EXPECT_EQ(row.at("threads"), "1");
    const auto summary = read_csv(folder_ / "r/summary.csv");
    ASSERT_EQ(summary.size(), 1u);
    EXPECT_EQ(summary[0].at("strategy"), "ctp/1thread");
    EXPECT_EQ(summary[0].at("ratio_to_reference"), "1");
}

// Rays that leave a single square hit nothing more.
TEST_F(PeersRun, BouncesThatNoPathReachesAreNoted) {
    write("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
    write("square.json", R"({"schema_version": 1, "name": "square", "mesh": {"file": "square.obj"},
        "camera": {"eye": [0, 0, 3], "target": [0, 0, 0], "up": [0, 1, 0], "fov": 60}})");
    write("c.json", R"({"schema_version": 1, "experiment": "x",
        "matrix": {"scene": "square", "spheres": 0, "strategy": "ctp"},
        "width": 16, "height": 16, "rounds": 1, "batch_bounces": [1, 3]})");
    const Outcome outcome = run("--quiet --config $D/c.json --scene-dir $D --out $D/r");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    const std::string meta = read(folder_ / "r/meta.json");
    EXPECT_NE(meta.find("square/0: no path reaches bounce 3, so that no rays of it are traced"),
              std::string::npos);
    EXPECT_EQ(meta.find("no path reaches bounce 1"), std::string::npos);
    const auto rows = read_csv(folder_ / "r/rows.csv");
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].at("bounce"), "1");
}

TEST_F(PeersRun, RefusesFramesWithThreadsOfTheirOwn) {
    const Outcome outcome =
        run_config(R"("matrix": {"scene": "smoke", "shade": "ctp", "threads": [1, 2]}, "tables": [])");
    EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
    EXPECT_NE(outcome.output.find("/matrix/threads: frames are rendered by the run's own threads"),
              std::string::npos)
        << outcome.output;
}

}  // namespace
}  // namespace ctpbench::test
