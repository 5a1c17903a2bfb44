// Broken input gets an error that names file, place and remedy, and a documented exit code.
#include "base/memory.h"
#include "run_program.h"

namespace ctpbench::test {
namespace {

class BadInput : public ProgramTest {
protected:
    void expect(const std::string& arguments, int exit_code, std::initializer_list<const char*> parts) const {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.exit_code, exit_code) << outcome.output;
        for (const char* part : parts)
            EXPECT_NE(outcome.output.find(part), std::string::npos) << "no \"" << part << "\" in:\n"
                                                                    << outcome.output;
    }
    // A config that measures one strategy on one scene.
    std::string config_for(const std::string& scene) const {
        write("c.json",
              R"({"schema_version": 1, "experiment": "x", "matrix": {"scene": ")" + scene +
                  R"(", "spheres": 0, "strategy": "ctp"}, "width": 16, "height": 16, "rounds": 1})");
        return "--quiet --config $D/c.json --scene-dir $D --out $D/r";
    }
    std::string obj(const std::string& text) const {
        write("mesh.obj", text);
        write("broken.json", R"({"schema_version": 1, "name": "broken", "mesh": {"file": "mesh.obj"},
            "camera": {"eye": [0, 0, 3], "target": [0, 0, 0], "up": [0, 1, 0], "fov": 60}})");
        return config_for("broken");
    }
};

TEST_F(BadInput, TruncatedConfig) {
    write("c.json", "{\"schema_version\": 1,\n \"experiment\": ");
    expect("--config $D/c.json", 2, {"c.json:2:", "error:"});
}

TEST_F(BadInput, EveryMistakeInAConfigAtOnce) {
    write("c.json", R"({"schema_version": 1, "experiment": "x",
  "matrix": {"scene": "smoke", "shperes": 5, "spheres": [-1], "strategy": "ctpp"},
  "rounds": 0, "rounds": 3})");
    expect("--config $D/c.json", 2, {"c.json:"});
    write("c.json", R"({"schema_version": 1, "experiment": "x",
  "matrix": {"scene": "smoke", "shperes": 5, "spheres": [-1], "strategy": "ctpp"},
  "rounds": 0})");
    expect("--config $D/c.json", 2,
           {"c.json:2:", "/matrix/shperes", "did you mean \"spheres\"", "/matrix/spheres", "-1", "ctpp",
            "did you mean \"ctp\"", "c.json:3:", "/rounds"});
}

TEST_F(BadInput, MissingConfig) { expect("--config $D/none.json", 2, {"none.json"}); }

TEST_F(BadInput, UnknownOption) { expect("--cofnig x", 2, {"--cofnig"}); }

TEST_F(BadInput, UnknownScene) { expect(config_for("smoek"), 2, {"smoek", "did you mean \"smoke\""}); }

// The last scene's mistakes show before the first one is measured, all of them at once.
TEST_F(BadInput, EveryScenesMistakesBeforeAnythingIsMeasured) {
    write("half.json", R"({"schema_version": 1, "name": "half", "recipe": {"nmae": "smoke"}})");
    write("absent.json", R"({"schema_version": 1, "name": "absent", "mesh": {"file": "no/such.obj"}})");
    const std::string arguments =
        config_for("smoke") + R"( --set '/matrix/scene=["smoke", "smoek", "half", "absent"]')";
    for (const char* also : {"", " --dry-run"})
        expect(arguments + also, 2,
               {"did you mean \"smoke\"", "half.json:1:", "did you mean \"name\"", "no/such.obj"});
    EXPECT_FALSE(std::filesystem::exists(folder_ / "r")) << "nothing was begun";
    expect(arguments + " --filter absent/", 3, {"no/such.obj"});
    expect(arguments + " --filter smoke/", 0, {});
}

TEST_F(BadInput, MissingMesh) {
    write("absent.json", R"({"schema_version": 1, "name": "absent", "mesh": {"file": "no/such.obj"},
        "stand_in": "smoke", "camera": {"eye": [0, 0, 3], "target": [0, 0, 0], "up": [0, 1, 0], "fov": 60}})");
    expect(config_for("absent") + " --scenes real", 3, {"no/such.obj", "fetch_scenes"});
    std::filesystem::remove_all(folder_ / "r");
    const Outcome instead = run(config_for("absent"));
    EXPECT_EQ(instead.exit_code, 0) << instead.output;
    for (const auto& row : read_csv(folder_ / "r/rows.csv")) EXPECT_EQ(row.at("scene_source"), "stand-in");
    EXPECT_NE(read(folder_ / "r/meta.json").find("stand-in"), std::string::npos);
}

TEST_F(BadInput, ObjWithAnIndexOutOfRange) {
    expect(obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n"), 2, {"mesh.obj:5", "9"});
}

TEST_F(BadInput, EmptyObj) { expect(obj(""), 2, {"mesh.obj"}); }

TEST_F(BadInput, ObjWithNothingButNaN) {
    expect(obj("v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), 2, {"mesh.obj"});
}

TEST_F(BadInput, NaNVerticesAreDroppedAndCounted) {
    const Outcome outcome = run(obj("v nan 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nf 1 2 3\nf 2 3 4\n"));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_NE(read(folder_ / "r/meta.json").find("\"dropped_triangles\": 1"), std::string::npos);
    for (const auto& row : read_csv(folder_ / "r/rows.csv")) EXPECT_EQ(row.at("triangles"), "1");
}

TEST_F(BadInput, MoreThanFitsIntoMemoryIsRefusedBeforeItIsTried) {
    const double pixels = 16384.0 * 16384.0, spheres = 5e7;
    if (static_cast<double>(available_memory_bytes()) > 100 * pixels + 200 * spheres)
        GTEST_SKIP() << "this machine has memory for all that a config may ask for";
    write("c.json", R"({"schema_version": 1, "experiment": "x", "width": 16384, "height": 16384,
        "matrix": {"scene": "smoke", "spheres": 50000000, "strategy": ["ctp", "oop", "restart"]}})");
    expect("--config $D/c.json --out $D/r", 2,
           {"smoke/50000000", "needs about", "bytes, but only", "fewer spheres"});
    EXPECT_FALSE(std::filesystem::exists(folder_ / "r"));
    expect("render smoke --image $D/i.exr --width 16384 --height 16384 --spheres 50000000", 2,
           {"the picture", "needs about"});
}

TEST_F(BadInput, ConfigsThatNeverEnd) {
    expect("--config /dev/zero", 2, {"/dev/zero", "larger than 1024 KiB"});
    const Outcome piped = run_shell("yes '[' | \"$P\" --config /dev/stdin");
    EXPECT_EQ(piped.exit_code, 2);
    EXPECT_NE(piped.output.find("larger than 1024 KiB"), std::string::npos) << piped.output;
}

TEST_F(BadInput, AMeshThatIsAPipe) {
    std::system(("mkfifo '" + (folder_ / "mesh.obj").string() + "'").c_str());
    write("broken.json", R"({"schema_version": 1, "name": "broken", "mesh": {"file": "mesh.obj"}})");
    expect(config_for("broken"), 3, {"mesh.obj"});
    expect("render $D/mesh.obj --image $D/i.exr", 3, {"mesh.obj"});
}

TEST_F(BadInput, ATextureOutsideTheMeshsFolder) {
    write("a.mtl", "newmtl a\nmap_Kd ../../../etc/passwd\n");
    expect(obj("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n"), 2,
           {"mesh.obj", "\"../../../etc/passwd\"", "outside the OBJ file's folder"});
}

TEST_F(BadInput, OutputThatCannotBeWritten) {
    write("file", "");
    const std::string config = config_for("smoke");
    expect(config.substr(0, config.find("--out")) + "--out $D/file/r", 8, {"file/r", "--out"});
}

TEST_F(BadInput, DiskFull) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    std::filesystem::create_directories(folder_ / "r");
    std::filesystem::create_symlink("/dev/full", folder_ / "r/meta.json.partial");
    const std::string config = config_for("smoke");
    expect(config, 8, {"meta.json", "No space left on device"});
}

}  // namespace
}  // namespace ctpbench::test
