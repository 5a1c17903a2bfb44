#include "scene/scene_file.h"

#include "kernels/materials/list.h"
#include "tests/scene/files.h"

namespace ctpbench {
namespace {

class SceneFileTest : public SceneFiles {
protected:
    SceneFile parse(const std::string& text) { return read_scene_file(write("a.json", text)); }
};

TEST_F(SceneFileTest, ReadsEveryKey) {
    const SceneFile file = parse(R"({
        "schema_version": 1, "name": "a",
        "mesh": [{"file": "a.obj", "triangles": 12, "variant": "v"},
                 {"file": ["b.obj", "c.obj"], "camera": {"eye": [1, 2, 3], "target": [0, 0, 0], "up": [0, 0, 1], "fov": 84},
                  "overrides": {"materials": {"x": {"type": "mirror"}}}}],
        "stand_in": "b", "paper_triangles": 13,
        "camera": {"eye": [0, 0, 5], "target": [0, 0, 0]},
        "spheres": {"count": 7, "radius": 0.5, "seed": 18446744073709551615, "specular": [0, 0.5, 1],
                    "placed": [{"center": [1, 2, 3], "radius": 0.25}, {"center": [4, 5, 6], "radius": 2}]},
        "ambient": [0, 2.5, 1], "exposure": 0.25,
        "overrides": {"materials": {
            "carpet": {"diffuse": [1, 0, 0]},
            "lamp": {"type": "emissive", "emission": [12, 0, 1], "specular": [0, 1, 0], "exponent": 500}}}
    })");
    EXPECT_EQ(file.name, "a");
    ASSERT_EQ(file.meshes.size(), 2u);
    EXPECT_EQ(file.meshes[0].triangles, 12u);
    EXPECT_EQ(file.meshes[0].variant, "v");
    EXPECT_FALSE(file.meshes[0].camera.has_value());
    EXPECT_EQ(file.meshes[1].files, (std::vector<std::string>{"b.obj", "c.obj"}));
    EXPECT_EQ(file.meshes[1].camera->fov_degrees, 84.0f);
    EXPECT_EQ(file.camera->up, (Vec3{0, 1, 0}));
    EXPECT_EQ(file.stand_in, "b");
    EXPECT_EQ(file.paper_triangles, 13u);
    EXPECT_EQ(file.spheres.count, 7u);
    EXPECT_EQ(file.spheres.seed, 18446744073709551615ull);
    EXPECT_EQ(file.spheres.specular, (Vec3{0, 0.5f, 1}));
    ASSERT_EQ(file.spheres.placed.size(), 2u);
    EXPECT_EQ(file.spheres.placed[1].center, (Vec3{4, 5, 6}));
    EXPECT_EQ(file.spheres.placed[0].radius, 0.25f);
    EXPECT_EQ(file.ambient, (Vec3{0, 2.5f, 1}));
    EXPECT_EQ(file.exposure, 0.25f);
    ASSERT_EQ(file.overrides.size(), 2u);
    const MaterialOverride& carpet = file.overrides[0];
    EXPECT_EQ(carpet.material, "carpet");
    EXPECT_EQ(carpet.place.line, 12u);
    EXPECT_EQ(carpet.diffuse, (Vec3{1, 0, 0}));
    EXPECT_FALSE(carpet.type || carpet.specular || carpet.emission || carpet.exponent);
    const MaterialOverride& lamp = file.overrides[1];
    EXPECT_EQ(lamp.type, material_type<Emissive>);
    EXPECT_EQ(lamp.emission, (Vec3{12, 0, 1}));
    EXPECT_EQ(lamp.specular, (Vec3{0, 1, 0}));
    EXPECT_EQ(lamp.exponent, 500.0f);
    EXPECT_FALSE(lamp.diffuse);
    EXPECT_TRUE(file.meshes[0].overrides.empty());
    ASSERT_EQ(file.meshes[1].overrides.size(), 1u);
    EXPECT_EQ(file.meshes[1].overrides[0].type, material_type<Mirror>);
}

TEST_F(SceneFileTest, ReadsARecipe) {
    const SceneFile file =
        parse(R"({"schema_version": 1, "name": "a", "recipe": {"name": "smoke", "seed": 3}})");
    ASSERT_TRUE(file.recipe.has_value());
    EXPECT_EQ(file.recipe->name, "smoke");
    EXPECT_EQ(file.recipe->seed, 3u);
    EXPECT_EQ(parse(R"({"schema_version": 1, "name": "a", "recipe": {"name": "grove"}})").recipe->triangles,
              100'000u);
    EXPECT_EQ(parse(R"({"schema_version": 1, "name": "a", "recipe": {"name": "grove", "triangles": 12345}})")
                  .recipe->triangles,
              12'345u);
    EXPECT_FALSE(file.camera.has_value());
}

TEST_F(SceneFileTest, NamesThePlaceOfEachMistake) {
    const std::string start = R"({"schema_version": 1, "name": "a", "mesh": {"file": "a.obj"}, )";
    const auto expect = [&](const std::string& rest, const std::string& part) {
        EXPECT_ERROR(parse(start + rest + "}"), ExitCode::usage, part);
    };
    expect("\n\"stand-in\": \"b\"", "a.json:2:1: error: /stand-in: unknown key; did you mean \"stand_in\"");
    expect(R"("recipe": {"name": "smoke"})", "either \"mesh\" or \"recipe\"");
    expect(R"("camera": {"eye": [0, 0, 0]})", "target");
    expect(R"("camera": {"eey": [1, 0, 0], "target": [0, 5, 0]})", "did you mean \"eye\"");
    const std::string message =
        error_of([&] { parse(start + R"("camera": {"eey": [1, 0, 0], "target": [0, 5, 0]}})"); }).second;
    EXPECT_EQ(message.find("along its view"), std::string::npos) << "what is missing is judged: " << message;
    expect(R"("camera": {"eye": [0, 0, 0], "target": [0, 5, 0]})", "must not be zero or along its view");
    expect(R"("camera": {"eye": [0, 0, 0], "target": [0, 0, 1], "fov": 180})", "fov");
    expect(R"("spheres": {"radius": 0})", "radius");
    expect(R"("spheres": {"count": -1})", "count");
    expect(R"("overrides": {"materials": {"x": {"diffuse": [2, 0, 0]}}})", "diffuse");
    expect(R"("overrides": {"materials": {"x": {}}})", "changes nothing");
    expect(R"("overrides": {"materials": {"x": {"type": "glass"}}})",
           R"(choices: "matte", "plastic", "mirror", "emissive")");
    expect(R"("overrides": {"materials": {"x": {"type": "plastik"}}})", "did you mean \"plastic\"");
    expect(R"("overrides": {"materials": {"x": {"type": "matte", "color": [0, 0, 0]}}})",
           "/color: unknown key");
    expect(R"("overrides": {"materials": {"x": {"emission": [0, -1, 0]}}})", "emission");
    expect(R"("overrides": {"materials": {"x": {"specular": [0, 1.5, 0]}}})", "specular");
    expect(R"("overrides": {"materials": {"x": {"exponent": -1}}})", "exponent");
    expect(R"("ambient": [0, 0, -0.5])", "ambient");
    expect(R"("ambient": 1)", "ambient");
    expect(R"("exposure": 0)", "exposure");
    expect(R"("spheres": {"diffuse": [1, 1, 1]})", "diffuse: unknown key");
    expect(R"("spheres": {"placed": [{"center": [0, 0, 0], "radius": 0}]})", "radius");
    expect(R"("spheres": {"placed": [{"radius": 1}]})", "center");
    expect(R"("overrides": {"material": {}})", "unknown key");
}

TEST_F(SceneFileTest, RefusesAnIncompleteScene) {
    EXPECT_ERROR(parse("{}"), ExitCode::usage, "schema_version");
    EXPECT_ERROR(parse(R"({"schema_version": 2, "name": "a", "mesh": {"file": "a.obj"}})"), ExitCode::usage,
                 "schema_version");
    EXPECT_ERROR(parse(R"({"schema_version": 1, "name": "a"})"), ExitCode::usage,
                 "either \"mesh\" or \"recipe\"");
    EXPECT_ERROR(parse(R"({"schema_version": 1, "name": "a", "mesh": {}})"), ExitCode::usage,
                 "needs a \"file\"");
    EXPECT_ERROR(parse(R"({"schema_version": 1, "name": "a", "mesh": []})"), ExitCode::usage,
                 "needs a \"file\"");
    EXPECT_ERROR(parse(R"({"schema_version": 1, "name": "a", "recipe": {"name": "smoke", "triangles": 9}})"),
                 ExitCode::usage, "smoke comes in one size");
    EXPECT_ERROR(parse(R"({"schema_version": 1, "name": "a", "recipe": {"name": "grove", "triangles": 9}})"),
                 ExitCode::usage, "10000");
    EXPECT_ERROR(parse(R"({"schema_version": 1, "name": "a", "recipe": {"name": "smok"}})"), ExitCode::usage,
                 "smoke");
    EXPECT_ERROR(parse(""), ExitCode::usage, "a.json");
    EXPECT_ERROR(read_scene_file(folder / "gone.json"), ExitCode::usage, "gone.json");
}

#ifdef CTPBENCH_SOURCE_DIR
TEST_F(SceneFileTest, TheScenesThatShipAreRight) {
    int scenes = 0;
    for (const fs::directory_entry& entry :
         fs::directory_iterator(fs::path(CTPBENCH_SOURCE_DIR) / "scenes")) {
        if (entry.path().extension() != ".json" || entry.path().stem() == "manifest") continue;
        const SceneFile file = read_scene_file(entry.path());
        EXPECT_EQ(file.name, entry.path().stem());
        if (!file.stand_in.empty()) {
            const SceneFile stand_in =
                read_scene_file(entry.path().parent_path() / (file.stand_in + ".json"));
            EXPECT_TRUE(stand_in.recipe.has_value());
        }
        ++scenes;
    }
    EXPECT_GE(scenes, 6);
}
#endif

}  // namespace
}  // namespace ctpbench
