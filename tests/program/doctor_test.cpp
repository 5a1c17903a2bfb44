// ctpbench --doctor: a line for each thing, and the exit code of the run that it examines.
#include "run_program.h"

namespace ctpbench::test {
namespace {

using Doctor = ProgramTest;

void expect_line(const Outcome& outcome, const std::string& line) {
    EXPECT_NE(("\n" + outcome.output).find("\n" + line), std::string::npos) << line << "\n" << outcome.output;
}

TEST_F(Doctor, SaysWhatThereIsAndLeavesNoTrace) {
    const Outcome outcome = run("--doctor --out $D/r/deep");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    for (const char* part : {"compiler", "build type", "git ", "Embree", "OpenImageIO", "CUDA",
                             "instructions", "processor", "cpu quota", "governor", "huge pages", "memory",
                             "load", "clock", "output", "scene smoke ", "scene conference ", "scalar"})
        EXPECT_NE(outcome.output.find(part), std::string::npos) << part << "\n" << outcome.output;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "r"));
}

TEST_F(Doctor, FailsAsTheRunWould) {
    write("file", "");
    const Outcome output = run("--doctor --out $D/file/r");
    EXPECT_EQ(output.exit_code, 8);
    EXPECT_NE(output.output.find("file/r cannot be written: name another with --out"), std::string::npos)
        << output.output;

    write("gone.json", R"({"schema_version": 1, "name": "gone", "mesh": {"file": "no/such.obj"},
        "stand_in": "smoke"})");
    expect_line(
        run("--doctor --scene-dir $D --out $D/r"),
        "missing  scene gone             its mesh is not here, smoke takes its place: scripts/fetch_scenes");
    EXPECT_EQ(run("--doctor --scene-dir $D --out $D/r").exit_code, 0);
    EXPECT_EQ(run("--doctor --scene-dir $D --out $D/r --scenes real").exit_code, 3);

    write("gone.json", "{");
    const Outcome broken = run("--doctor --scene-dir $D --out $D/r");
    EXPECT_EQ(broken.exit_code, 2);
    EXPECT_NE(broken.output.find("gone.json:1:"), std::string::npos) << broken.output;
}

TEST_F(Doctor, FailsWithoutABackendThatIsNamed) {
    const bool usable = run("--doctor --out $D/r").output.find("missing  CUDA") == std::string::npos;
    EXPECT_EQ(run("--doctor --out $D/r --backend cuda").exit_code, usable ? 0 : 7);
    EXPECT_EQ(run("--doctor --out $D/r --backend auto").exit_code, 0);
}

}  // namespace
}  // namespace ctpbench::test
