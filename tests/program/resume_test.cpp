// Runs that were cut short and go on: what is kept, what is measured again, and what is refused.
#include <unistd.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "measured_rows.h"
#include "run_program.h"

namespace ctpbench::test {
namespace {

class Resume : public ProgramTest {
protected:
    void SetUp() override {
        ProgramTest::SetUp();
        write("c.json", R"({"schema_version": 1, "experiment": "x",
            "matrix": {"scene": "smoke", "spheres": [0, 20, 60, 200], "strategy": ["ctp", "restart"]},
            "width": 32, "height": 16, "bounces": 2, "rounds": 2, "batch_rays": 0, "oracle_rays": 100})");
    }
    Outcome measure(const std::string& more = "") const {
        return run("--quiet --config $D/c.json --out $D/r " + more);
    }
    void expect_refused(const std::string& more, std::initializer_list<const char*> parts) const {
        const std::string rows = read(at("rows.csv")), meta = read(at("meta.json"));
        const Outcome outcome = measure("--resume " + more);
        EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
        for (const char* part : parts)
            EXPECT_NE(outcome.output.find(part), std::string::npos) << "no \"" << part << "\" in:\n"
                                                                    << outcome.output;
        EXPECT_EQ(read(at("rows.csv")), rows);
        EXPECT_EQ(read(at("meta.json")), meta);
    }
    std::filesystem::path at(const char* name) const { return folder_ / "r" / name; }
    nlohmann::json meta() const { return nlohmann::json::parse(read(at("meta.json"))); }

    // The first n lines.
    static std::string head(const std::string& text, int n) {
        std::size_t end = 0;
        for (int i = 0; i < n; ++i) end = text.find('\n', end) + 1;
        return text.substr(0, end);
    }
    void overwrite(const char* name, const std::string& text) const {
        std::ofstream(at(name), std::ios::binary | std::ios::trunc) << text;
    }
    // As a run leaves it that is killed in its third workload, with these words at the ends of both files.
    void cut_to_two_workloads(const std::string& torn_mark, const std::string& torn_row) const {
        const std::string marks = read(at("finished.jsonl")), rows = read(at("rows.csv"));
        overwrite("finished.jsonl", head(marks, 2) + torn_mark);
        const auto second = nlohmann::json::parse(head(marks, 2).substr(head(marks, 1).size()));
        overwrite("rows.csv", rows.substr(0, second.at("rows_end").get<std::size_t>()) + torn_row);
    }
};

TEST_F(Resume, MeasuresWhatIsMissingAndCutsTornTails) {
    ASSERT_EQ(measure().exit_code, 0);
    const std::string rows = read(at("rows.csv"));
    const auto whole = keys_of(read_csv(at("rows.csv")));
    const std::string run_id = meta().at("run_id");
    cut_to_two_workloads("{\"hash\": \"01", "x-20261126T000000Z,x,smoke,stand-in,30");
    const Outcome outcome = run("--config $D/c.json --out $D/r --resume");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("resumed: 2 finished workloads"), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find(", and 38 bytes of rows.csv are cut"), std::string::npos) << outcome.output;
    EXPECT_EQ(keys_of(read_csv(at("rows.csv"))), whole);
    // What was kept was not measured again: its times are the same to the last digit.
    EXPECT_EQ(read(at("rows.csv")).substr(0, rows.size() / 3), rows.substr(0, rows.size() / 3));
    EXPECT_EQ(meta().at("run_id"), run_id);
    EXPECT_EQ(meta().at("state"), "complete");
    EXPECT_EQ(meta().at("resumed")[0].at("workloads_kept"), 2);
    EXPECT_EQ(meta().at("scenes").size(), 4u);
    EXPECT_EQ(read_csv(at("summary.csv")).size(), 8u);
}

// Of a contest that a signal ends, the finished rounds are kept; a resumed run measures it as a whole.
TEST_F(Resume, MeasuresAContestAgainThatWasInterrupted) {
    const Outcome outcome = run_shell(
        "D='" + folder_.string() +
        "'; \"$P\" --config $D/c.json --out $D/r --quiet --set /matrix/spheres=20 --rounds 1000 & pid=$!; "
        "for i in $(seq 600); do [ \"$(wc -l <$D/r/rows.csv 2>/dev/null || echo 0)\" -gt 5 ] && break; "
        "sleep 0.02; done; kill -INT $pid; wait $pid");
    ASSERT_EQ(outcome.exit_code, 130) << outcome.output;
    EXPECT_GT(read_csv(at("rows.csv")).size(), 3u);
    const Outcome resumed = measure("--resume --set /matrix/spheres=20 --rounds 1000");
    ASSERT_EQ(resumed.exit_code, 0) << resumed.output;
    EXPECT_EQ(read_csv(at("rows.csv")).size(), 1000u * 2 * 3);
}

TEST_F(Resume, TwoProcessesDoNotWriteToOneFolder) {
    const Outcome outcome = run_shell(
        "D='" + folder_.string() +
        "'; R=\"$P --config $D/c.json --out $D/r --quiet --rounds 10000\"; $R & pid=$!; "
        "for i in $(seq 600); do [ \"$(wc -l <$D/r/rows.csv 2>/dev/null || echo 0)\" -gt 5 ] && break; "
        "sleep 0.02; done; $R --resume; echo \"code $?\"; kill -9 $pid; wait $pid");
    EXPECT_NE(outcome.output.find("rows.csv: error: another process writes to it"), std::string::npos)
        << outcome.output;
    EXPECT_NE(outcome.output.find("code 8"), std::string::npos) << outcome.output;
}

TEST_F(Resume, OfACompleteRunLeavesEveryTableAsItIs) {
    struct Case {
        const char* config;
        std::string more;
    };
    const std::string small = " --set /width=64 --set /height=32 --set /matrix/scene=smoke";
    for (const auto& [config, more] : std::initializer_list<Case>{
             {"smoke", small + " --rounds 2"},
             {"table2", small + " --filter smoke/1000"},
             {"pareto", small + " --rounds 2 --set /stress_rays=2000"},
             {"profile", small + " --rounds 2"},
             {"peers", small + " --rounds 2"},
             {"table1", small + " --rounds 2 --filter smoke/0/cpu/restart+"},
             {"stability", " --set /stress_rays=500 --filter edges/"},
             {"convergence",
              " --set /matrix/scene=smoke --set /include=[] --set /width=16 --set /height=8 --set /seeds=4 "
              "--set /samples=64 --set /reference_samples=64"}}) {
        std::filesystem::remove_all(folder_ / "r");
        const std::string command = std::string("--quiet --out $D/r --config $C/") + config + ".json" + more;
        const Outcome first = run(command);
        ASSERT_EQ(first.exit_code, 0) << config << ": " << first.output;
        std::map<std::filesystem::path, std::string> before;
        for (const auto& entry : std::filesystem::directory_iterator(folder_ / "r"))
            before[entry.path()] = read(entry.path());
        const Outcome second = run(command + " --resume");
        ASSERT_EQ(second.exit_code, 0) << config << ": " << second.output;
        for (const auto& [path, text] : before) {
            if (path.filename() != "meta.json") {
                EXPECT_EQ(read(path), text) << config << ": " << path;
                continue;
            }
            const auto then = nlohmann::json::parse(text), now = meta();
            for (const char* key : {"run_id", "command", "config", "scenes", "trees", "oracle", "exams",
                                    "notices", "workloads", "state"})
                EXPECT_EQ(now.at(key), then.at(key)) << config << ": " << key;
        }
    }
}

TEST_F(Resume, BeginsWhereThereIsNothing) {
    ASSERT_EQ(measure("--resume").exit_code, 0);
    EXPECT_EQ(read_csv(at("summary.csv")).size(), 8u);
    EXPECT_EQ(meta().at("resumed").size(), 0u);
    // A run that is killed before its first row has left meta.json, and maybe a beginning of the header.
    overwrite("rows.csv", "run_id,exp");
    overwrite("finished.jsonl", "");
    ASSERT_EQ(measure("--resume").exit_code, 0);
    EXPECT_EQ(read_csv(at("summary.csv")).size(), 8u);
}

TEST_F(Resume, RefusesAnotherRun) {
    ASSERT_EQ(measure().exit_code, 0);
    expect_refused("--rounds 3", {"/config/rounds: 2 there, 3 here", "--out"});
    expect_refused("--seed 5 --threads 1", {"/config/seed: 1 there, 5 here", "/config/threads: 0 there, 1"});
    expect_refused("--filter /restart/", {"/workloads/0/contenders: 2 there, 1 here"});
    expect_refused("--shard 1/2", {"/shard: \"1/1\" there, \"1/2\" here"});
    auto other = meta();
    other["build"]["git_commit"] = "0123";
    overwrite("meta.json", other.dump());
    expect_refused("", {"/build/git_commit: \"0123\" there"});
    other = meta();
    other["machine"]["cpu"] = "Z80";
    overwrite("meta.json", other.dump());
    expect_refused("", {"/machine/cpu: \"Z80\" there"});
    const Outcome nowhere = run("--quiet --config $D/c.json --resume");
    EXPECT_EQ(nowhere.exit_code, 2);
    EXPECT_NE(nowhere.output.find("--out"), std::string::npos) << nowhere.output;
}

TEST_F(Resume, RefusesRowsThatAreNotTheRuns) {
    ASSERT_EQ(measure().exit_code, 0);
    std::string rows = read(at("rows.csv"));
    const std::string marks = read(at("finished.jsonl"));
    rows[rows.size() / 2] ^= 1;
    overwrite("rows.csv", rows);
    expect_refused("", {"rows.csv", "not those that the run wrote"});
    overwrite("rows.csv", rows.substr(0, rows.size() / 3));
    expect_refused("", {"rows.csv", "has less than"});
    overwrite("finished.jsonl", head(marks, 1) + "nonsense\n" + marks);
    expect_refused("", {"finished.jsonl:2:", "damaged"});
}

TEST_F(Resume, RefusesAnotherScene) {
    const auto scene = [&](const char* eye) {
        write("square.json", std::string(R"({"schema_version": 1, "name": "square",
            "mesh": {"file": "square.obj"}, "camera": {"eye": )") +
                                 eye + R"(, "target": [0, 0, 0], "up": [0, 1, 0], "fov": 60}})");
    };
    const char* square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
    write("square.obj", square);
    scene("[0, 0, 3]");
    const std::string more = "--scene-dir $D --set /matrix/scene=square --set /matrix/spheres=0";
    ASSERT_EQ(measure(more).exit_code, 0);
    write("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\nf 1 2 3\nf 1 3 4\n");
    expect_refused(more, {"scene square: hash"});
    write("square.obj", square);
    scene("[0, 0, 4]");  // seen from elsewhere
    expect_refused(more, {"scene square: hash"});
    scene("[0, 0, 3]");
    EXPECT_EQ(measure("--resume " + more).exit_code, 0);
}

// A limit on the size of files stands in for a disk that is full.
TEST_F(Resume, KeepsWhatIsThereWhenTheDiskIsFull) {
    ASSERT_EQ(measure("--rounds 8").exit_code, 0);
    const auto whole = keys_of(read_csv(at("rows.csv")));
    const std::size_t blocks = std::filesystem::file_size(at("rows.csv")) * 2 / 3 / 512;
    std::filesystem::remove_all(folder_ / "r");
    const Outcome full =
        run_shell("D='" + folder_.string() + "'; trap '' XFSZ; ulimit -f " + std::to_string(blocks) +
                  "; \"$P\" --quiet --config $D/c.json --out $D/r --rounds 8");
    EXPECT_EQ(full.exit_code, 8) << full.output;
    for (const char* part : {"rows.csv", "File too large", "--resume"})
        EXPECT_NE(full.output.find(part), std::string::npos) << full.output;
    const std::string rows = read(at("rows.csv"));
    ASSERT_FALSE(rows.empty());
    EXPECT_EQ(rows.back(), '\n') << "half a line is left";
    const auto finished = read(at("finished.jsonl"));
    EXPECT_GE(std::count(finished.begin(), finished.end(), '\n'), 1);
    const Outcome resumed = measure("--resume --rounds 8");
    ASSERT_EQ(resumed.exit_code, 0) << resumed.output;
    EXPECT_EQ(keys_of(read_csv(at("rows.csv"))), whole);
}

// Permissions stop everyone but root, who can be someone else for once.
TEST_F(Resume, SaysThatWhatIsThereIsReadOnly) {
    ASSERT_EQ(measure().exit_code, 0);
    std::filesystem::permissions(folder_, std::filesystem::perms::all);
    const std::string other =
        geteuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups " : "chmod a-w $D/r/* $D/r; ";
    const std::string command = "D='" + folder_.string() + "'; " + other;
    if (run_shell(command + "\"$P\" --version").exit_code != 0)
        GTEST_SKIP() << "this user may write anywhere, and cannot run the program as another";
    const std::string rows = read(at("rows.csv")), meta = read(at("meta.json"));
    const Outcome outcome = run_shell(command + "\"$P\" --quiet --config $D/c.json --out $D/r --resume");
    if (geteuid() != 0) run_shell(command + "chmod u+w $D/r");
    EXPECT_EQ(outcome.exit_code, 8) << outcome.output;
    EXPECT_NE(outcome.output.find("Permission denied"), std::string::npos) << outcome.output;
    EXPECT_NE(outcome.output.find((folder_ / "r").string()), std::string::npos) << outcome.output;
    EXPECT_EQ(read(at("rows.csv")), rows);
    EXPECT_EQ(read(at("meta.json")), meta);
}

}  // namespace
}  // namespace ctpbench::test
