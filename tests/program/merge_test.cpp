// Shards of a run, measured apart, make the results of one.
#include <nlohmann/json.hpp>

#include "measured_rows.h"
#include "run_program.h"

namespace ctpbench::test {
namespace {

#ifdef CTPBENCH_HAS_OPENIMAGEIO
const char* kImages = "--set /images=true";
#else
const char* kImages = "";
#endif

class Merge : public ProgramTest {
protected:
    void SetUp() override {
        ProgramTest::SetUp();
        write("c.json", R"({"schema_version": 1, "experiment": "x",
            "matrix": {"scene": "smoke", "spheres": [0, 20, 60], "strategy": ["ctp", "restart"]},
            "include": [{"scene": "smoke", "spheres": [20, 60], "shade": ["ctp", "sort"]}],
            "width": 32, "height": 16, "bounces": 2, "rounds": 2, "batch_rays": 0, "oracle_rays": 100})");
    }
    Outcome measure(const std::string& out, const std::string& more) const {
        return run("--quiet --config $D/c.json --out $D/" + out + " " + more);
    }
    void expect_refused(const std::string& folders, std::initializer_list<const char*> parts) const {
        const Outcome outcome = run("merge " + folders + " --out $D/m");
        EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
        for (const char* part : parts)
            EXPECT_NE(outcome.output.find(part), std::string::npos) << "no \"" << part << "\" in:\n"
                                                                    << outcome.output;
        EXPECT_FALSE(std::filesystem::exists(folder_ / "m"));
    }
    nlohmann::json meta(const char* folder) const {
        return nlohmann::json::parse(read(folder_ / folder / "meta.json"));
    }
};

TEST_F(Merge, ShardsAreTheWhole) {
    const std::string images = kImages;
    ASSERT_EQ(measure("whole", images).exit_code, 0);
    for (const char* shard : {"2", "1"})
        ASSERT_EQ(measure(std::string("s") + shard, images + " --shard " + shard + "/2").exit_code, 0);
    // Shards are disjoint, and neither is all.
    EXPECT_EQ(meta("s1").at("scenes").size(), 2u);
    EXPECT_EQ(meta("s2").at("scenes").size(), 1u);
    const Outcome merged = run("merge $D/s2 $D/s1 --out $D/m");
    ASSERT_EQ(merged.exit_code, 0) << merged.output;
    EXPECT_EQ(keys_of(read_csv(folder_ / "m/rows.csv")), keys_of(read_csv(folder_ / "whole/rows.csv")));
    for (const char* table : {"summary.csv", "trees.csv", "table3.csv", "table1.csv"}) {
        const auto ours = read_csv(folder_ / "m" / table), theirs = read_csv(folder_ / "whole" / table);
        ASSERT_EQ(ours.size(), theirs.size()) << table;
        for (std::size_t i = 0; i < ours.size(); ++i)
            for (const char* key : {"scene", "spheres", "strategy", "tree", "kernel", "image_hash"}) {
                if (theirs[i].count(key)) {
                    EXPECT_EQ(ours[i].at(key), theirs[i].at(key)) << table << ":" << i + 2;
                }
            }
    }
    for (const char* key : {"scenes", "trees", "oracle", "config", "workloads", "shard", "state"})
        EXPECT_EQ(meta("m").at(key), meta("whole").at(key)) << key;
    EXPECT_EQ(meta("m").at("parts").size(), 2u);
    if (!images.empty()) {
        EXPECT_TRUE(std::filesystem::exists(folder_ / "m/smoke-20.exr"));  // which says when it was made
        for (const char* name : {"smoke-20.png", "smoke-60.png"})
            EXPECT_EQ(read(folder_ / "m" / name), read(folder_ / "whole" / name)) << name;
    }
    // A merged folder is one of a run: complete, and what is made from it stays the same.
    const std::string summary = read(folder_ / "m/summary.csv");
    ASSERT_EQ(measure("m", images + " --resume").exit_code, 0);
    EXPECT_EQ(read(folder_ / "m/summary.csv"), summary);
}

TEST_F(Merge, RefusesWhatIsNotOneRun) {
    ASSERT_EQ(measure("s1", "--shard 1/2").exit_code, 0);
    ASSERT_EQ(measure("s2", "--shard 2/2 --rounds 3").exit_code, 0);
    expect_refused("$D/s1 $D/s2", {"s2: /config/rounds: 3 there, 2 here"});
    expect_refused("$D/s1", {"smoke/20: finished in none of the folders", "--resume"});
    expect_refused("$D/s1 $D/s1", {"smoke/0: finished in", "name one of them", "smoke/60"});
    expect_refused("$D/s1 $D/none", {"none/meta.json"});
}

TEST_F(Merge, RefusesAnotherScene) {
    const auto scene = [&](const char* height) {
        write("square.obj",
              std::string("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 ") + height + "\nf 1 2 3\nf 1 3 4\n");
    };
    write("square.json", R"({"schema_version": 1, "name": "square", "mesh": {"file": "square.obj"},
        "camera": {"eye": [0, 0, 3], "target": [0, 0, 0], "up": [0, 1, 0], "fov": 60}})");
    const std::string more = "--scene-dir $D --set /matrix/scene=square --set /include=[] --shard ";
    scene("0");
    ASSERT_EQ(measure("s1", more + "1/2").exit_code, 0);
    scene("0.5");
    ASSERT_EQ(measure("s2", more + "2/2").exit_code, 0);
    expect_refused("$D/s1 $D/s2", {"scene square: hash", "s1", "s2"});
}

TEST_F(Merge, RefusesADamagedMeta) {
    ASSERT_EQ(measure("s1", "--shard 1/2").exit_code, 0);
    ASSERT_EQ(measure("s2", "--shard 2/2").exit_code, 0);
    auto damaged = meta("s1");
    for (auto& workload : damaged["workloads"]) workload.erase("hash");
    for (const char* folder : {"s1/meta.json", "s2/meta.json"})
        std::ofstream(folder_ / folder) << damaged.dump();
    expect_refused("$D/s1 $D/s2", {"meta.json", "hash", "measure that shard again"});
}

TEST_F(Merge, UnlikeMachinesAreNoted) {
    ASSERT_EQ(measure("s1", "--shard 1/2").exit_code, 0);
    ASSERT_EQ(measure("s2", "--shard 2/2").exit_code, 0);
    auto other = meta("s2");
    other["machine"]["cpu"] = "Z80";
    std::ofstream(folder_ / "s2/meta.json") << other.dump();
    const Outcome merged = run("merge $D/s1 $D/s2 --out $D/m");
    EXPECT_EQ(merged.exit_code, 0);
    EXPECT_NE(merged.output.find("unlike machines"), std::string::npos) << merged.output;
    EXPECT_NE(meta("m").at("notices").dump().find("Z80"), std::string::npos);
}

}  // namespace
}  // namespace ctpbench::test
