// Whole runs of a small experiment: what they leave behind, and what must hold of it.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "run_program.h"

namespace ctpbench::test {
namespace {

// The smoke experiment, smaller still.
const char* kSmall = " --config $C/smoke.json --quiet --rounds 2 --set /width=64 --set /height=32";

// What rows say of sound hits.
#ifdef CTPBENCH_EMBREE
const char* kValid = "true";
#else
const char* kValid = "unchecked";  // there is no oracle to ask
#endif

class Run : public ProgramTest {};

TEST_F(Run, LeavesRowsAndTables) {
    const Outcome outcome = run(std::string("--out $D/r") + kSmall);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    for (const char* file :
         {"rows.csv", "summary.csv", "trees.csv", "table2.csv", "table3.csv", "table3.md", "meta.json"})
        EXPECT_TRUE(std::filesystem::exists(folder_ / "r" / file)) << file;
    const auto rows = read_csv(folder_ / "r/rows.csv");
    ASSERT_FALSE(rows.empty());
    std::map<std::string, std::set<std::string>> hashes;
    std::set<std::string> strategies;
    for (const auto& row : rows) {
        EXPECT_EQ(row.at("valid"), kValid);
        EXPECT_EQ(row.at("scene_source"), "stand-in");
        if (row.at("shade") != "none") continue;
        EXPECT_GT(std::stod(row.at("throughput_mrays_s")), 0.0);
        EXPECT_NEAR(std::stod(row.at("rays")) / std::stod(row.at("time_ms")) * 1e-3,
                    std::stod(row.at("throughput_mrays_s")), 1e-3 * std::stod(row.at("throughput_mrays_s")));
        strategies.insert(row.at("strategy"));
        if (row.at("methods") == "watertight")
            hashes[row.at("spheres") + "/" + row.at("bounce")].insert(row.at("hit_hash"));
    }
    for (const auto& [batch, distinct] : hashes) EXPECT_EQ(distinct.size(), 1u) << batch;
    for (const char* name : {"ctp", "std_variant", "oop", "oop_arena", "restart", "typed_leaves"})
        EXPECT_TRUE(strategies.count(name)) << name;
    const std::string meta = read(folder_ / "r/meta.json");
    EXPECT_NE(meta.find("\"state\": \"complete\""), std::string::npos);
}

// A square in two alike materials, an idle material and a vertex too many, without and with spheres.
TEST_F(Run, MetaSaysWhatScenesNeedAndWhatTheyTake) {
    write("square.obj",
          "mtllib square.mtl\nv 0 0 0\nv 9 9 9\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nusemtl idle\n"
          "usemtl a\nf 1/1 3/1 4/1\nusemtl b\nf 1/1 4/1 5/1\n");
    write("square.mtl", "newmtl a\nKd 1 0 0\nnewmtl b\nKd 1 0 0\nnewmtl idle\nKe 1 1 1\nmap_Kd gone.png\n");
    write("square.json", R"({"schema_version": 1, "name": "square", "mesh": {"file": "square.obj"},
        "camera": {"eye": [0, 0, 3], "target": [0, 0, 0], "up": [0, 1, 0], "fov": 60}})");
    write("c.json", R"({"schema_version": 1, "experiment": "x",
        "matrix": {"scene": "square", "spheres": [0, 3], "strategy": "ctp"},
        "width": 16, "height": 16, "rounds": 1})");
    const Outcome outcome = run("--quiet --config $D/c.json --scene-dir $D --out $D/r");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    const auto scenes = nlohmann::json::parse(read(folder_ / "r/meta.json")).at("scenes");
    ASSERT_EQ(scenes.size(), 2u);
    using nlohmann::json;
    for (const json& scene : scenes)
        EXPECT_EQ(scene.at("dropped"), json::parse(R"({"unused_vertices": 1, "unused_texcoords": 2,
            "unused_materials": 1, "merged_materials": 1})"));
    EXPECT_EQ(scenes[0].at("needs"),
              json::parse(R"({"primitives": ["triangle"], "materials": ["matte"], "textured": false})"));
    EXPECT_EQ(scenes[1].at("needs"), json::parse(R"({"primitives": ["triangle", "sphere"],
        "materials": ["matte", "mirror"], "textured": false})"));
    const json& alone = scenes[0].at("bytes");
    EXPECT_EQ(alone.at("positions"), 4 * 12);
    EXPECT_EQ(alone.at("triangles"), 2 * 12);
    EXPECT_EQ(alone.at("material_words"), 2 * 4);
    for (const char* none : {"texcoords", "texels", "spheres"}) EXPECT_EQ(alone.at(none), 0) << none;
    EXPECT_EQ(scenes[1].at("bytes").at("spheres"), 3 * 16);
    EXPECT_EQ(scenes[1].at("bytes").at("materials"), 2 * alone.at("materials").get<int>());
}

TEST_F(Run, HitsDoNotDependOnThreads) {
    std::vector<std::vector<std::string>> hashes;
    for (const char* threads : {"1", "2"}) {
        const std::string out = std::string("t") + threads;
        const Outcome outcome = run("--out $D/" + out + " --threads " + threads + " --filter /ctp/" + kSmall);
        ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
        auto& column = hashes.emplace_back();
        for (const auto& row : read_csv(folder_ / out / "rows.csv")) {
            column.push_back(row.at("hit_hash"));
            EXPECT_EQ(row.at("threads"), threads);
        }
    }
    EXPECT_FALSE(hashes[0].empty());
    EXPECT_EQ(hashes[0], hashes[1]);
}

TEST_F(Run, RefusesToMixTwoRuns) {
    ASSERT_EQ(run(std::string("--out $D/r --filter /ctp/") + kSmall).exit_code, 0);
    const std::string before = read(folder_ / "r/rows.csv");
    const Outcome second = run(std::string("--out $D/r --filter /ctp/") + kSmall);
    EXPECT_EQ(second.exit_code, 8);
    EXPECT_NE(second.output.find("another run"), std::string::npos) << second.output;
    EXPECT_EQ(read(folder_ / "r/rows.csv"), before);
}

TEST_F(Run, KeepsWhatWasMeasuredWhenInterrupted) {
    // Enough rounds for minutes; the signal comes as soon as the first rows are there.
    const Outcome outcome = run_shell("D='" + folder_.string() +
                                      "'; \"$P\" --config '" CTPBENCH_SOURCE_DIR
                                      "/configs/smoke.json' --out $D/r "
                                      "--quiet --rounds 10000 --filter /ctp/ & pid=$!; "
                                      "for i in $(seq 600); do [ \"$(wc -l <$D/r/rows.csv 2>/dev/null || "
                                      "echo 0)\" -gt 5 ] && break; sleep 0.1; done; "
                                      "kill -INT $pid; wait $pid");
    EXPECT_EQ(outcome.exit_code, 130) << outcome.output;
    EXPECT_NE(outcome.output.find("interrupted: what was measured is in"), std::string::npos)
        << outcome.output;
    const auto rows = read_csv(folder_ / "r/rows.csv");
    ASSERT_GT(rows.size(), 3u);
    for (const auto& row : rows) EXPECT_EQ(row.at("valid"), kValid);
    EXPECT_NE(read(folder_ / "r/meta.json").find("\"state\": \"interrupted\""), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(folder_ / "r/summary.csv"));
}

TEST_F(Run, RendersAScene) {
    const Outcome outcome =
        run("render smoke --spheres 20 --samples 3 --width 64 --height 48 --image $D/smoke.png");
    if (outcome.output.find("without OpenImageIO") != std::string::npos)
        GTEST_SKIP() << "built without OpenImageIO";
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("20 spheres"), std::string::npos) << outcome.output;
    // A picture with something in it does not compress to nothing.
    EXPECT_GT(std::filesystem::file_size(folder_ / "smoke.png"), 2000u);
    const Outcome refused = run("render smoke --width 8 --height 8 --image $D/no/such/folder.png");
    EXPECT_EQ(refused.exit_code, 8) << refused.output;
    EXPECT_NE(refused.output.find("folder.png"), std::string::npos) << refused.output;
}

// Whole frames: every shade strategy gives the same image, and Table 1 and Figure 4 come of it.
TEST_F(Run, ComparesShadeStrategies) {
    const Outcome outcome = run(std::string("--out $D/r --filter restart+") + kSmall);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    std::map<std::string, std::set<std::string>> kernels, images;
    for (const auto& row : read_csv(folder_ / "r/rows.csv")) {
        EXPECT_EQ(row.at("valid"), kValid);
        kernels[row.at("shade")].insert(row.at("kernel"));
        if (row.at("kernel") == "blend") {
            images[row.at("round")].insert(row.at("image_hash"));
            EXPECT_EQ(row.at("clamped_samples"), "0");
        }
        EXPECT_EQ(row.at("dropped_samples").empty(), row.at("kernel") != "shade");
    }
    EXPECT_EQ(kernels.size(), 7u);
    EXPECT_EQ(kernels.at("sort"),
              (std::set<std::string>{"generate", "intersect", "copy", "sort", "shade", "compact", "blend"}));
    EXPECT_EQ(kernels.at("queues").count("compact"), 0u);
    EXPECT_EQ(images.size(), 2u);
    for (const auto& [round, distinct] : images) EXPECT_EQ(distinct.size(), 1u) << round;
    std::set<std::string> in_summary;
    for (const auto& line : read_csv(folder_ / "r/summary.csv")) in_summary.insert(line.at("image_hash"));
    EXPECT_EQ(in_summary, images.at("1"));

    const auto table = read_csv(folder_ / "r/table1.csv");
    ASSERT_EQ(table.size(), 4u);
    EXPECT_EQ(table[1].at("kernel"), "sort");
    EXPECT_EQ(table[1].at("smoke+200/cpu/ctp"), "n/a");
    EXPECT_GT(std::stod(table[1].at("smoke+200/cpu/sort")), 0.0);
    EXPECT_EQ(read_csv(folder_ / "r/figure4.csv").size(), 4u * 3 + 2 * 4 + 2);
}

TEST_F(Run, WritesWhatItsFramesAccumulated) {
    const Outcome outcome = run(std::string("--out $D/r --set /images=true --filter restart+ctp") + kSmall);
    if (outcome.output.find("without OpenImageIO") != std::string::npos)
        GTEST_SKIP() << "built without OpenImageIO";
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_GT(std::filesystem::file_size(folder_ / "r/smoke-200.exr"), 2000u);
    EXPECT_GT(std::filesystem::file_size(folder_ / "r/smoke-200.png"), 300u);
}

// That the estimate is near is for a machine that does nothing else; here it must grow as the run does.
TEST_F(Run, DryRunSaysHowLongItWouldTakeAndLeavesNothing) {
    const auto seconds = [&](const std::string& more) {
        const Outcome dry =
            run("--dry-run --out $D/r --config $C/smoke.json --set /width=64 --set /height=32 " + more);
        EXPECT_EQ(dry.exit_code, 0) << dry.output;
        EXPECT_NE(dry.output.find("typed_leaves"), std::string::npos);
        const std::size_t at = dry.output.find("\nall ");
        EXPECT_NE(at, std::string::npos) << dry.output;
        double value = 0.0;
        char colon = 0, after = 0;
        std::istringstream text(dry.output.substr(dry.output.find("about", at) + 5));
        text >> value >> colon >> after;
        return colon == ':' ? 60.0 * value : value;
    };
    const double few = seconds("--rounds 2"), many = seconds("--rounds 2000");
    EXPECT_GT(many, 20.0 * few);
    EXPECT_LT(many, 5000.0 * few);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "r"));
    const Outcome shard = run(std::string("--dry-run --shard 2/2") + kSmall);
    EXPECT_EQ(shard.output.find("typed_leaves"), std::string::npos) << "smoke has one workload";
}

TEST_F(Run, ListAndVersionMeasureNothing) {
    const Outcome list = run("--list");
    EXPECT_EQ(list.exit_code, 0);
    for (const char* name :
         {"san_miguel", "smoke", "typed_leaves", "watertight", "embree_robust", "quality", "cpu"})
        EXPECT_NE(list.output.find(name), std::string::npos) << name;
    EXPECT_EQ(run("--version").output.rfind("ctpbench ", 0), 0u);
    const Outcome help = run("--help");
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_NE(help.output.find("--config"), std::string::npos);
    EXPECT_NE(help.output.find("130"), std::string::npos) << "exit codes are documented";
}

}  // namespace
}  // namespace ctpbench::test
