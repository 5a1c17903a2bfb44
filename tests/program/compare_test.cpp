// `ctpbench compare`, stop rules and scripts/regression_gate, as a user meets them.
#include <algorithm>

#include "report/noisy_run.h"
#include "run_program.h"

namespace ctpbench::test {
namespace {

class Compare : public ProgramTest {
protected:
    // A run of the gate's experiment, small enough for a test.
    const std::string small_ =
        " --set /matrix/scene=smoke --set /width=160 --set /height=64 --set /batch_rays=1024 --set "
        "/rounds=41 "
        "--set /max_noise=0";
};

TEST_F(Compare, ExitCodesSayWhatWasFound) {
    NoisyRun plain, slow, vague, few;
    slow.contenders[0].speed /= 1.3;
    vague.noise = 0.3, vague.rounds = 11;
    few.contenders.erase(few.contenders.begin());
    plain.write(folder_ / "base", 1), plain.write(folder_ / "same", 2), slow.write(folder_ / "slow", 3);
    vague.write(folder_ / "vague", 4), few.write(folder_ / "few", 5);
    const auto code = [this](const std::string& arguments) { return run(arguments).exit_code; };
    EXPECT_EQ(code("compare $D/base $D/same --strict"), 0);
    EXPECT_EQ(code("compare $D/base $D/slow"), 5);
    EXPECT_EQ(code("compare $D/base $D/slow --strict"), 5);
    EXPECT_EQ(code("compare $D/base $D/slow --fail-ratio 0.7"), 0);
    EXPECT_EQ(code("compare $D/slow $D/base --strict"), 0);
    EXPECT_EQ(code("compare $D/base $D/vague"), 0);
    EXPECT_EQ(code("compare $D/base $D/vague --strict"), 6);
    EXPECT_EQ(code("compare $D/base $D/few"), 0);
    EXPECT_EQ(code("compare $D/base $D/few --strict"), 6);
    EXPECT_EQ(code("compare $D/base $D/none"), 2);
}

TEST_F(Compare, PrintsWhatItFound) {
    NoisyRun plain, slow;
    slow.contenders[0].speed /= 1.3, slow.cpu = "another processor";
    plain.write(folder_ / "base", 1), slow.write(folder_ / "slow", 2);
    const std::string text = run("compare $D/base $D/slow").output;
    EXPECT_NE(text.find("cpu: a processor | another processor"), std::string::npos) << text;
    EXPECT_NE(text.find("SLOWER, REGRESSION"), std::string::npos) << text;
    EXPECT_NE(text.find("1 SAME, 0 FASTER, 1 SLOWER, 0 UNCLEAR, 0 not compared; 1 of them a regression"),
              std::string::npos)
        << text;
}

TEST_F(Compare, NamesWhatCannotBeRead) {
    const Outcome nothing = run("compare $D/none $D/none");
    EXPECT_EQ(nothing.exit_code, 2);
    EXPECT_NE(nothing.output.find("no results here"), std::string::npos) << nothing.output;
    NoisyRun plain, other;
    other.threads = 7;
    plain.write(folder_ / "a", 1), other.write(folder_ / "b", 2);
    const Outcome unlike = run("compare $D/a $D/b");
    EXPECT_EQ(unlike.exit_code, 2);
    EXPECT_NE(unlike.output.find("only in BASE"), std::string::npos) << unlike.output;
    write("a/rows.csv", "run_id,scene\r\nr,smoke\r\n");
    const Outcome old = run("compare $D/a $D/b");
    EXPECT_EQ(old.exit_code, 2);
    EXPECT_NE(old.output.find("rows.csv:1: error: no column"), std::string::npos) << old.output;
}

TEST_F(Compare, RunsStopWhenTheyAreToldTo) {
    const std::string config = "--config $C/regression.json --quiet" + small_;
    ASSERT_EQ(run(config + " --out $D/time --min-time 1").exit_code, 0);
    ASSERT_EQ(run(config + " --out $D/late --rounds 10000 --timeout 0.2").exit_code, 0);
    ASSERT_EQ(run(config + " --out $D/calm --max-noise 0.9 --timeout 60").exit_code, 0);
    double timed = 0.0;
    for (const auto& row : read_csv(folder_ / "time/rows.csv")) timed += std::stod(row.at("time_ms"));
    EXPECT_GT(timed, 500.0);  // what lies between kernels counts too
    EXPECT_EQ(read_csv(folder_ / "time/summary.csv").front().at("stopped_by"), "min_time");
    const auto late = read_csv(folder_ / "late/summary.csv").front();
    EXPECT_EQ(late.at("stopped_by"), "timeout");
    EXPECT_LT(std::stoi(late.at("rounds")), 10000);
    EXPECT_NE(read(folder_ / "late/meta.json").find("stopped by timeout"), std::string::npos);
    const auto calm = read_csv(folder_ / "calm/summary.csv").front();
    EXPECT_EQ(calm.at("stopped_by"), "max_noise");
    EXPECT_GE(std::stoi(calm.at("rounds")), 41);
    // And all of these can be compared, whatever their number of rounds.
    EXPECT_EQ(run("compare $D/time $D/calm --fail-ratio 0.1").exit_code, 0);
}

// The program behind a script that makes ctp take ten times as long in the rows of the first N runs.
TEST_F(Compare, TheGateNeedsARegressionTwiceInARow) {
    const auto slow = write("slow", R"(#!/usr/bin/env bash
"$PROGRAM" "$@" || exit
[ "$1" != compare ] || exit 0
left=$(cat "$LEFT")
[ "$left" -gt 0 ] || exit 0
echo $((left - 1)) >"$LEFT"
while [ "$1" != --out ]; do shift; done
awk -F, -v OFS=, 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i }
  NR > 1 && $at["strategy"] == "ctp" && $at["time_ms"] != "" { $at["time_ms"] *= 10 } { print }' "$2/rows.csv" >"$2/slow"
mv "$2/slow" "$2/rows.csv"
)");
    std::filesystem::permissions(slow, std::filesystem::perms::owner_all);
    const auto gate = [&](const std::string& options) {
        return run_shell("D='" + folder_.string() +
                         "'; export PROGRAM=\"$P\" LEFT=$D/left; '" CTPBENCH_SOURCE_DIR
                         "/scripts/regression_gate' " +
                         options + small_);
    };
    const std::string with = "--program $D/slow --baselines $D/baselines";
    write("left", "0");
    EXPECT_EQ(gate(with).exit_code, 2);  // there is no baseline yet
    const Outcome recorded = gate("--record " + with);
    ASSERT_EQ(recorded.exit_code, 0) << recorded.output;

    const Outcome calm = gate(with);
    EXPECT_EQ(calm.exit_code, 0) << calm.output;
    write("left", "2");
    const Outcome twice = gate(with);
    EXPECT_EQ(twice.exit_code, 5) << twice.output;
    EXPECT_NE(twice.output.find("measuring once more"), std::string::npos) << twice.output;

    // Beside the baseline of another processor the limit is lower, and this is said.
    const auto own = std::filesystem::directory_iterator(folder_ / "baselines")->path();
    std::filesystem::rename(own, folder_ / "baselines/another");
    write("left", "1");
    const Outcome once = gate(with);
    EXPECT_EQ(once.exit_code, 0) << once.output;
    EXPECT_NE(once.output.find("beside another, with limit 0.7"), std::string::npos) << once.output;
    EXPECT_NE(once.output.find("measuring once more"), std::string::npos) << once.output;
}

}  // namespace
}  // namespace ctpbench::test
