#include "scene/material_library.h"

#include "tests/scene/files.h"

namespace ctpbench {
namespace {

class MaterialLibrary : public SceneFiles {
protected:
    std::vector<Material> read_for(const std::string& obj) {
        const fs::path path = write("a.obj", obj + "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
        return read_materials(parse_obj(read(path), path.string()), path, notices);
    }
};

TEST_F(MaterialLibrary, ReadsDiffuseColoursClamped) {
    write("sub/a.mtl", "newmtl other\nKd 0 0 0\nnewmtl red\nKd 1.5 0.25 -1\nmap_Kd x.png\n");
    const auto materials = read_for("mtllib sub/a.mtl\n");
    ASSERT_EQ(materials.size(), 1u);
    EXPECT_EQ(materials[0].name, "red");
    EXPECT_EQ(materials[0].look.diffuse, (Vec3{1, 0.25f, 0}));
    EXPECT_TRUE(notices.empty());
}

TEST_F(MaterialLibrary, ReadsEveryLibraryOfALine) {
    write("a.mtl", "newmtl other\nKd 0 0 0\n");
    write("b.mtl", "newmtl red\nKd 1 0 0\n");
    EXPECT_EQ(read_for("mtllib a.mtl b.mtl\n")[0].look.diffuse, (Vec3{1, 0, 0}));
}

TEST_F(MaterialLibrary, NoticesAMissingLibrary) {
    const auto materials = read_for("mtllib gone.mtl\n");
    EXPECT_EQ(materials[0].look.diffuse, Material{}.look.diffuse);
    EXPECT_TRUE(has_notice(notices, "a.obj:1: material library \"gone.mtl\" cannot be read"));
    EXPECT_TRUE(has_notice(
        notices, "a.obj:5: 1 of its materials are in no MTL file and get the default grey: \"red\""));
}

TEST_F(MaterialLibrary, NoticesAnUnknownMaterial) {
    write("a.mtl", "newmtl blue\nKd 0 0 1\n");
    EXPECT_EQ(read_for("mtllib a.mtl\n")[0].look.diffuse, Material{}.look.diffuse);
    EXPECT_EQ(notices.size(), 1u);
    EXPECT_TRUE(has_notice(notices, "\"red\""));
}

TEST_F(MaterialLibrary, NoticesAnEmptyLibraryAndAFolder) {
    write("a.mtl", "");
    read_for("mtllib a.mtl\n");
    EXPECT_TRUE(has_notice(notices, "in no MTL file"));
    fs::create_directory(folder / "b.mtl");
    read_for("mtllib b.mtl\n");
    EXPECT_TRUE(has_notice(notices, "\"b.mtl\" cannot be read"));
}

TEST_F(MaterialLibrary, RefusesFilesOutsideTheFolder) {
    EXPECT_ERROR(read_for("mtllib ../a.mtl\n"), ExitCode::usage,
                 "a.obj:1: material library \"../a.mtl\" is outside");
    EXPECT_ERROR(read_for("mtllib x/../../a.mtl\n"), ExitCode::usage, "is outside");
    EXPECT_ERROR(read_for("mtllib /etc/passwd\n"), ExitCode::usage, "is outside");
    write("a.mtl", "newmtl red\nKd 1 0 0\n");
    EXPECT_EQ(read_for("mtllib x/../a.mtl\n").size(), 1u);  // stays inside
}

TEST_F(MaterialLibrary, FacesBeforeAnyMaterialAreGreyWithoutANotice) {
    const auto mesh = parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj");
    const auto materials = read_materials(mesh, "a.obj", notices);
    ASSERT_EQ(materials.size(), 1u);
    EXPECT_EQ(materials[0].name, "default");
    EXPECT_TRUE(notices.empty());
}

}  // namespace
}  // namespace ctpbench
