#include "scene/load_scene.h"

#include "kernels/materials/list.h"
#include "tests/scene/files.h"

namespace ctpbench {
namespace {

const std::string kObj = "mtllib a.mtl\nv 0 0 0\nv 4 0 0\nv 0 2 0\nv 0 0 1\nusemtl red\nf 1 2 3\nf 1 2 4\n";
const std::string kCamera = R"("camera": {"eye": [1, 2, 3], "target": [0, 0, 0]})";

std::string scene_text(const std::string& rest) {
    return R"({"schema_version": 1, "name": "a", )" + rest + "}";
}

// A scene "a" with a mesh in folder "one" and a stand-in "b" of one triangle.
class LoadScene : public SceneFiles {
protected:
    void SetUp() override {
        SceneFiles::SetUp();
        write("one/a.json",
              scene_text(R"("mesh": {"file": "a/a.obj", "triangles": 2}, "stand_in": "b", )" + kCamera));
        write("one/a/a.obj", kObj);
        write("one/a/a.mtl", "newmtl red\nKd 1 0 0\n");
        write("one/b.json",
              scene_text(R"("mesh": {"file": "b.obj"}, "camera": {"eye": [9, 9, 9], "target": [0, 0, 0]})"));
        write("one/b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        request.name = "a";
        request.scene_dirs = {folder / "one"};
    }
    Scene load() { return load_scene(request, notices); }
    void remove_mesh() { fs::remove(folder / "one/a/a.obj"); }

    SceneRequest request;
};

TEST_F(LoadScene, ReadsTheMesh) {
    const Scene scene = load();
    EXPECT_EQ(scene.name, "a");
    EXPECT_EQ(scene.source, SceneSource::mesh);
    EXPECT_EQ(scene.mesh.triangles.size(), 2u);
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_EQ(scene.materials[0].look.diffuse, (Vec3{1, 0, 0}));
    EXPECT_EQ(scene.camera.eye, (Vec3{1, 2, 3}));
    EXPECT_TRUE(scene.spheres.empty());
    EXPECT_NE(scene.content_hash, 0u);
    EXPECT_TRUE(notices.empty());
    EXPECT_EQ(load().content_hash, scene.content_hash);  // from the cache
}

TEST_F(LoadScene, AutoTakesTheStandInForAMissingMesh) {
    remove_mesh();
    const Scene scene = load();
    EXPECT_EQ(scene.name, "a");
    EXPECT_EQ(scene.source, SceneSource::stand_in);
    EXPECT_EQ(scene.mesh.triangles.size(), 1u);
    EXPECT_EQ(scene.camera.eye, (Vec3{9, 9, 9}));
    EXPECT_TRUE(has_notice(notices, "the stand-in \"b\" takes its place"));
}

TEST_F(LoadScene, RealFailsForAMissingMesh) {
    remove_mesh();
    request.choice = SceneChoice::real;
    EXPECT_ERROR(load(), ExitCode::scene_missing, "scripts/fetch_scenes");
    EXPECT_ERROR(load(), ExitCode::scene_missing, "a/a.obj");
    EXPECT_ERROR(load(), ExitCode::scene_missing, (folder / "one").string());
    EXPECT_ERROR(load(), ExitCode::scene_missing, (folder / "home/.cache/ctpbench/scenes").string());
}

TEST_F(LoadScene, StandInIsTakenThoughTheMeshIsThere) {
    request.choice = SceneChoice::stand_in;
    EXPECT_EQ(load().source, SceneSource::stand_in);
    EXPECT_EQ(load().mesh.triangles.size(), 1u);
    EXPECT_TRUE(notices.empty());
}

TEST_F(LoadScene, WithoutAStandInThereIsNoChoice) {
    request.name = "b";
    request.choice = SceneChoice::stand_in;
    EXPECT_ERROR(load(), ExitCode::usage, "has no stand-in");
    fs::remove(folder / "one/b.obj");
    request.choice = SceneChoice::auto_;
    EXPECT_ERROR(load(), ExitCode::scene_missing, "its mesh was not found");
}

TEST_F(LoadScene, BuildsARecipe) {
    write("one/r.json", scene_text(R"("recipe": {"name": "smoke", "seed": 1})"));
    request.name = "r";
    const Scene scene = load();
    EXPECT_EQ(scene.source, SceneSource::stand_in);
    EXPECT_FALSE(scene.mesh.triangles.empty());
    EXPECT_FALSE(scene.materials.empty());
    EXPECT_NE(scene.camera.eye, Camera{}.eye);
    request.choice = SceneChoice::real;
    EXPECT_ERROR(load(), ExitCode::scene_missing, "procedural");
}

TEST_F(LoadScene, MovesARecipeToItsOrigin) {
    request.name = "r";
    write("one/r.json", scene_text(R"("recipe": {"name": "smoke"})"));
    const Scene here = load();
    write("one/r.json", scene_text(R"("recipe": {"name": "smoke", "origin": [10000, 0, -5]})"));
    const Scene there = load();
    ASSERT_EQ(here.mesh.positions.size(), there.mesh.positions.size());
    const Vec3 origin{10000.0f, 0.0f, -5.0f};
    for (std::size_t i = 0; i < here.mesh.positions.size(); ++i)
        ASSERT_EQ(there.mesh.positions[i], here.mesh.positions[i] + origin) << i;
    EXPECT_NE(here.content_hash, there.content_hash);
    EXPECT_NEAR(there.camera.eye.x, here.camera.eye.x + 10000.0f, 0.01f);  // which frames the scene
}

TEST_F(LoadScene, SearchesTheFoldersInOrder) {
    const std::string one_triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    write("home/.cache/ctpbench/scenes/a/a.obj", one_triangle + "f 1 2 3\nf 1 2 3\n");
    EXPECT_EQ(load().mesh.triangles.size(), 2u);  // the given folder is first
    remove_mesh();
    EXPECT_EQ(load().mesh.triangles.size(), 3u);  // home is last
    write("env/a/a.obj", one_triangle + "f 1 2 3\nf 1 2 3\nf 1 2 3\n");
    ::setenv("CTPBENCH_SCENES", (":/nowhere:" + (folder / "env").string()).c_str(), 1);
    EXPECT_EQ(load().mesh.triangles.size(), 4u);
    write("two/a.json",
          scene_text(R"("mesh": {"file": "a/a.obj"}, "camera": {"eye": [7, 7, 7], "target": [0, 0, 0]})"));
    request.scene_dirs.insert(request.scene_dirs.begin(), folder / "two");
    EXPECT_EQ(load().camera.eye, (Vec3{7, 7, 7}));

    const Folders folders = scene_search_path({folder / "x", folder / "x"});
    ASSERT_GE(folders.size(), 4u);
    EXPECT_EQ(folders[0], folder / "x");
    EXPECT_EQ(folders[1], "/nowhere");
    EXPECT_EQ(folders[2], folder / "env");
    EXPECT_EQ(folders[3], folder / "home/.cache/ctpbench/scenes");
}

TEST_F(LoadScene, TakesTheFirstEditionThatIsThere) {
    write("one/a.json", scene_text(R"("mesh": [
        {"file": ["gone.obj", "gone too.obj"]},
        {"file": ["gone.obj", "b.obj"], "camera": {"eye": [5, 5, 5], "target": [0, 0, 0]}},
        {"file": "a/a.obj"}], )" + kCamera));
    EXPECT_EQ(load().camera.eye, (Vec3{5, 5, 5}));
    fs::remove(folder / "one/b.obj");
    EXPECT_EQ(load().camera.eye, (Vec3{1, 2, 3}));
}

TEST_F(LoadScene, TakesPaths) {
    request.scene_dirs.clear();
    request.name = (folder / "one/a.json").string();
    EXPECT_EQ(load().mesh.triangles.size(), 2u);  // its mesh lies beside it
    request.name = (folder / "one/a/a.obj").string();
    const Scene scene = load();
    EXPECT_EQ(scene.mesh.triangles.size(), 2u);
    EXPECT_EQ(scene.name, request.name);
    EXPECT_EQ(scene.camera.target, (Vec3{2, 1, 0.5f}));
    request.scene_dirs = {folder / "one"};
    request.name = "b.obj";
    EXPECT_EQ(load().mesh.triangles.size(), 1u) << "an OBJ in a folder that is searched";
    request.name = (folder / "gone.obj").string();
    EXPECT_ERROR(load(), ExitCode::scene_missing, request.name);
    request.name = (folder / "gone.json").string();
    EXPECT_ERROR(load(), ExitCode::usage, request.name);
}

TEST_F(LoadScene, SuggestsAName) {
    write("one/conference.json", "{}");
    request.name = "conferense";
    EXPECT_ERROR(load(), ExitCode::usage, "unknown scene \"conferense\"; did you mean \"conference\"?");
}

TEST_F(LoadScene, NoticesOtherTriangleCounts) {
    write("one/a.json",
          scene_text(R"("mesh": {"file": "a/a.obj", "triangles": 5, "variant": "a cut-down copy"},
                                       "paper_triangles": 331000)"));
    load();
    EXPECT_TRUE(has_notice(notices, "2 triangles, but the scene file expects 5"));
    EXPECT_TRUE(has_notice(notices, "2 triangles, but the paper's mesh has 331K: a cut-down copy"));
}

TEST_F(LoadScene, CountsDroppedTriangles) {
    write("one/a/a.obj", kObj + "f 1 1 2\nv nan 0 0\nf 1 2 5\n");
    const Scene scene = load();
    EXPECT_EQ(scene.dropped_triangles, 2u);
    EXPECT_EQ(scene.mesh.triangles.size(), 2u);
    EXPECT_TRUE(has_notice(
        notices, "a.obj:9: the first of the dropped triangles: 1 without area, 1 with a coordinate"));
    EXPECT_TRUE(has_notice(notices, "4 triangles, but the scene file expects 2"));  // what the file holds
}

TEST_F(LoadScene, OverridesMaterials) {
    write("one/a.json", scene_text(R"("mesh": {"file": "a/a.obj"},
        "overrides": {"materials": {"red": {"diffuse": [0, 1, 0]}}})"));
    EXPECT_EQ(load().materials[0].look.diffuse, (Vec3{0, 1, 0}));
    write("one/a.json", scene_text(R"("mesh": {"file": "a/a.obj"},
        "overrides": {"materials": {"rad": {"diffuse": [0, 1, 0]}}})"));
    EXPECT_ERROR(load(), ExitCode::usage,
                 "a.json:2:37: error: unknown material \"rad\"; did you mean \"red\"?");
}

TEST_F(LoadScene, OverridesTypesAndTheRest) {
    write("one/a.json", scene_text(R"("mesh": {"file": "a/a.obj",
        "overrides": {"materials": {"red": {"type": "mirror"}}}},
        "overrides": {"materials": {"red": {"type": "plastic", "specular": [0, 1, 0], "exponent": 7,
                                            "emission": [5, 0, 0]}}})"));
    const MaterialDescription look = load().materials[0].look;
    EXPECT_EQ(look.type, material_type<Mirror>);  // the edition has the last word
    EXPECT_EQ(look.specular, (Vec3{0, 1, 0}));
    EXPECT_EQ(look.exponent, 7.0f);
    EXPECT_EQ(look.emission, (Vec3{5, 0, 0}));
    EXPECT_EQ(look.diffuse, (Vec3{1, 0, 0}));
}

TEST_F(LoadScene, LeavesOutWhatNoRayCanAskFor) {
    write("one/a/a.obj",
          "v 9 9 9\nusemtl idle\n" + kObj.substr(0, kObj.find("f 1")) + "f 2 3 4\nusemtl rouge\nf 2 3 5\n");
    write("one/a/a.mtl", "newmtl red\nKd 1 0 0\nnewmtl rouge\nKd 1 0 0\nnewmtl idle\n");
    for (int i = 0; i < 2; ++i) {  // the second time from the cache, which holds what the file does
        const Scene scene = load();
        EXPECT_EQ(scene.savings, (SceneSavings{1, 0, 1, 1}));
        EXPECT_EQ(scene.mesh.positions.size(), 4u);
        EXPECT_EQ(scene.mesh.positions[0], (Vec3{0, 0, 0}));
        EXPECT_EQ(scene.mesh.material, (std::vector<std::uint32_t>{0, 0}));
        ASSERT_EQ(scene.materials.size(), 1u);
        EXPECT_EQ(scene.materials[0].name, "red");
    }
}

TEST_F(LoadScene, LeavesOutWhatARecipesOverridesMakeAlike) {
    const std::string recipe = R"("recipe": {"name": "smoke", "seed": 1})";
    write("one/r.json", scene_text(recipe));
    request.name = "r";
    const Scene plain = load();
    std::size_t other = 1;
    while (plain.materials[other].look.type != plain.materials[0].look.type) ++other;
    const auto white = [](const Material& m) {
        return "\"" + m.name + R"(": {"type": "matte", "diffuse": [1, 1, 1]})";
    };
    write("one/r.json", scene_text(recipe + R"(, "overrides": {"materials": {)" + white(plain.materials[0]) +
                                   ", " + white(plain.materials[other]) + "}}"));
    const Scene scene = load();
    EXPECT_EQ(scene.materials.size(), plain.materials.size() - 1);
    EXPECT_EQ(scene.savings.merged_materials, plain.savings.merged_materials + 1);
    EXPECT_EQ(scene.mesh.triangles, plain.mesh.triangles);
}

// They are those of the file, be they used or not, or like others.
TEST_F(LoadScene, OverridesNameMaterialsThatAreLeftOut) {
    write("one/a/a.obj", "usemtl idle\n" + kObj + "usemtl rouge\nf 1 3 4\n");
    write("one/a/a.mtl", "newmtl red\nKd 1 0 0\nnewmtl rouge\nKd 1 0 0\n");
    const auto with = [&](const std::string& name) {
        write("one/a.json", scene_text(R"("mesh": {"file": "a/a.obj"},
            "overrides": {"materials": {")" +
                                       name + R"(": {"diffuse": [0, 0, 1]}}})"));
        return load();
    };
    EXPECT_EQ(with("idle").materials.size(), 1u);
    const Scene apart = with("rouge");
    ASSERT_EQ(apart.materials.size(), 2u);
    EXPECT_EQ(apart.materials[1].look.diffuse, (Vec3{0, 0, 1}));
    EXPECT_ERROR(with("idel"), ExitCode::usage, "unknown material \"idel\"; did you mean \"idle\"?");
}

TEST_F(LoadScene, TakesLightAndExposureOfTheFileWithTheTriangles) {
    write("one/b.json", scene_text(R"("mesh": {"file": "b.obj"}, "ambient": [0, 2, 0], "exposure": 3,
        "spheres": {"placed": [{"center": [0, 9, 0], "radius": 1}]})"));
    const Scene plain = load();
    EXPECT_EQ(plain.ambient, (Vec3{1, 1, 1}));
    EXPECT_EQ(plain.exposure, 1.0f);
    EXPECT_TRUE(plain.spheres.empty());
    request.choice = SceneChoice::stand_in;
    const Scene scene = load();
    EXPECT_EQ(scene.ambient, (Vec3{0, 2, 0}));
    EXPECT_EQ(scene.exposure, 3.0f);
    EXPECT_EQ(scene.spheres.size(), 1u);
}

TEST_F(LoadScene, PlacesSpheresBeforeTheScatteredOnes) {
    const std::string mesh = R"("mesh": {"file": "a/a.obj"}, )";
    write("one/a.json", scene_text(mesh + R"("spheres": {"count": 3})"));
    const Scene scattered = load();
    write("one/a.json", scene_text(mesh + R"("spheres": {"count": 3, "specular": [1, 0, 0],
        "placed": [{"center": [100, 0, 0], "radius": 9}]})"));
    const Scene both = load();
    ASSERT_EQ(both.spheres.size(), 4u);
    EXPECT_EQ(both.spheres[0].center, (Vec3{100, 0, 0}));
    EXPECT_EQ(both.spheres[0].radius, 9.0f);
    for (int i = 0; i < 3; ++i) {  // in the triangles' bounds, whatever is placed outside
        EXPECT_EQ(both.spheres[i + 1].center, scattered.spheres[i].center);
        EXPECT_EQ(both.spheres[i + 1].radius, scattered.spheres[i].radius);
    }
    EXPECT_EQ(both.materials.at(both.sphere_material).look.specular, (Vec3{1, 0, 0}));
    request.spheres = 0;
    const Scene placed = load();
    EXPECT_EQ(placed.spheres.size(), 1u);
    EXPECT_EQ(placed.materials.at(placed.sphere_material).look.type, material_type<Mirror>);
}

TEST_F(LoadScene, NoticesBrokenTextureCoordinates) {
    write("one/a/a.obj", "vt nan 0\n" + kObj);
    load();
    EXPECT_TRUE(has_notice(notices, "a.obj:1: the first of 1 texture coordinates that are NaN"));
}

TEST_F(LoadScene, ScattersSpheres) {
    write("one/a.json",
          scene_text(R"("mesh": {"file": "a/a.obj"}, "spheres": {"count": 3, "radius": 0.5, "seed": 2})"));
    const Scene scene = load();
    ASSERT_EQ(scene.spheres.size(), 3u);
    EXPECT_NEAR(scene.spheres[0].radius, 0.5 * std::cbrt(8.0 / 3.0), 1e-6);
    EXPECT_EQ(scene.sphere_material, 1u);
    EXPECT_EQ(scene.materials[1].name, "spheres");
    EXPECT_EQ(scene.materials[1].look.type, material_type<Mirror>);
    EXPECT_EQ(scene.materials[1].look.specular, (Vec3{0.9f, 0.9f, 0.9f}));

    request.spheres = 1000;
    request.sphere_radius = 0.1f;
    request.seed = 9;
    const Scene other = load();
    EXPECT_EQ(other.spheres.size(), 1000u);
    EXPECT_NEAR(other.spheres[0].radius, 0.1 * std::cbrt(8.0 / 1000.0), 1e-6);
    EXPECT_FALSE(other.spheres[0].center == scene.spheres[0].center);
    EXPECT_NE(other.content_hash, scene.content_hash);
    request.spheres = 0;
    EXPECT_EQ(load().materials.size(), 1u);
}

}  // namespace
}  // namespace ctpbench
