#include "scene/mesh_cache.h"

#include "scene/cached_mesh.h"
#include "tests/scene/files.h"

namespace ctpbench {
namespace {

const std::string kObj =
    "mtllib a b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nvt 0.25 0.5\nvt inf 0\nf 1/1 2/1 3/2\n"
    "usemtl two words\nf 3 2 1\nf 1 2 4\nf 1 1 2\n";

class MeshCache : public SceneFiles {
protected:
    void SetUp() override {
        SceneFiles::SetUp();
        obj = write("a.obj", kObj);
        cache = folder / "cache";
        cached = cache / MeshKey::of(kObj).file_name();
    }
    ObjMesh load() { return load_obj(obj, cache, notices); }

    static void expect_equal(const ObjMesh& a, const ObjMesh& b) {
        EXPECT_EQ(a.mesh.positions.size(), b.mesh.positions.size());
        EXPECT_EQ(a.mesh.positions[1], b.mesh.positions[1]);
        EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
        EXPECT_EQ(a.mesh.material, b.mesh.material);
        ASSERT_EQ(a.mesh.texcoords.size(), b.mesh.texcoords.size());
        for (std::size_t i = 0; i < a.mesh.texcoords.size(); ++i) {
            for (int k = 0; k < 3; ++k) {
                EXPECT_EQ(a.mesh.texcoords[i][k].x, b.mesh.texcoords[i][k].x);
                EXPECT_EQ(a.mesh.texcoords[i][k].y, b.mesh.texcoords[i][k].y);
            }
        }
        EXPECT_EQ(a.bad_texcoords.count, b.bad_texcoords.count);
        EXPECT_EQ(a.bad_texcoords.first_line, b.bad_texcoords.first_line);
        const auto equal = [](const ObjName& x, const ObjName& y) {
            return x.name == y.name && x.line == y.line;
        };
        EXPECT_TRUE(std::equal(a.materials.begin(), a.materials.end(), b.materials.begin(), b.materials.end(),
                               equal));
        EXPECT_TRUE(std::equal(a.libraries.begin(), a.libraries.end(), b.libraries.begin(), b.libraries.end(),
                               equal));
        EXPECT_EQ(a.dropped.bad_vertex, b.dropped.bad_vertex);
        EXPECT_EQ(a.dropped.zero_area, b.dropped.zero_area);
        EXPECT_EQ(a.dropped.first_line, b.dropped.first_line);
    }

    fs::path obj, cache, cached;
};

TEST_F(MeshCache, GivesBackWhatWasParsed) {
    const ObjMesh parsed = load();
    ASSERT_TRUE(fs::exists(cached));
    expect_equal(load(), parsed);
    expect_equal(load_obj(obj, std::nullopt, notices), parsed);
    ASSERT_EQ(parsed.mesh.texcoords.size(), 2u);
    EXPECT_EQ(parsed.mesh.texcoords[0][1].y, 0.5f);
    EXPECT_EQ(parsed.libraries.size(), 2u);
    EXPECT_EQ(parsed.materials[1].name, "two words");
    EXPECT_TRUE(notices.empty());
    EXPECT_EQ(std::distance(fs::directory_iterator(cache), {}), 1);  // no unfinished file is left
}

TEST_F(MeshCache, KeepsAMeshWithoutTextureCoordinates) {
    const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    obj = write("a.obj", text);
    load();
    ASSERT_TRUE(fs::exists(cache / MeshKey::of(text).file_name()));
    EXPECT_TRUE(load().mesh.texcoords.empty());
    EXPECT_TRUE(notices.empty());
}

TEST_F(MeshCache, IsWhatIsReadTheSecondTime) {
    ObjMesh other = load();
    other.mesh.positions[1] = {7, 7, 7};
    write_cached_mesh(cached, MeshKey::of(kObj), other);
    EXPECT_EQ(load().mesh.positions[1], (Vec3{7, 7, 7}));
}

TEST_F(MeshCache, MissesWhenTheFileChanges) {
    load();
    obj = write("a.obj", kObj + "f 2 3 1\n");
    EXPECT_EQ(load().mesh.triangles.size(), 3u);
}

TEST_F(MeshCache, ReplacesADamagedFile) {
    const ObjMesh parsed = load();
    const std::string good = read(cached);
    const auto expect_repair = [&](const std::string& damaged) {
        notices.clear();
        std::ofstream(cached, std::ios::binary) << damaged;
        expect_equal(load(), parsed);
        EXPECT_TRUE(has_notice(notices, "is damaged"));
        EXPECT_EQ(read(cached), good);
    };
    expect_repair("");
    expect_repair(good.substr(0, 40));
    expect_repair(good.substr(0, good.size() - 1));
    expect_repair(good + "x");
    for (std::size_t at = 0; at < good.size(); ++at) {
        std::string damaged = good;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x81);
        expect_repair(damaged);
    }
}

TEST_F(MeshCache, RefusesAnotherMeshUnderItsName) {
    load();
    EXPECT_FALSE(read_cached_mesh(cached, MeshKey::of("other")).has_value());
}

TEST_F(MeshCache, NoticesAFolderThatCannotBeWritten) {
    cache = write("a file", "") / "cache";  // holds for root, too
    EXPECT_EQ(load().mesh.triangles.size(), 2u);
    EXPECT_TRUE(has_notice(notices, "the parsed mesh cannot be kept in"));
}

TEST_F(MeshCache, NoticesAFileThatCannotBeRead) {
    fs::create_directories(cached);
    EXPECT_EQ(load().mesh.triangles.size(), 2u);
    EXPECT_TRUE(has_notice(notices, "cannot be read"));
}

TEST_F(MeshCache, AnObjFileThatCannotBeReadIsMissing) {
    EXPECT_ERROR(load_obj(folder / "gone.obj", cache, notices), ExitCode::scene_missing,
                 "gone.obj: the OBJ file cannot be read: No such file");
    EXPECT_ERROR(load_obj(folder, cache, notices), ExitCode::scene_missing, "Is a directory");
    EXPECT_ERROR(load_obj(write("empty.obj", ""), cache, notices), ExitCode::usage, "is empty");
}

TEST_F(MeshCache, FollowsTheEnvironment) {
    EXPECT_EQ(mesh_cache_folder(), folder / "cache");
    ::unsetenv("CTPBENCH_CACHE");
    EXPECT_EQ(mesh_cache_folder(), folder / "home" / ".cache" / "ctpbench" / "parsed");
    ::unsetenv("HOME");
    EXPECT_EQ(mesh_cache_folder(), std::nullopt);
}

}  // namespace
}  // namespace ctpbench
