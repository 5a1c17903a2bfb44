#include "scene/material_library.h"

#include <sys/stat.h>

#include "kernels/materials/list.h"
#include "tests/scene/files.h"

namespace ctpbench {
namespace {

class MaterialLibrary : public SceneFiles {
protected:
    MeshMaterials read_all(const std::string& obj) {
        const fs::path path = write("a.obj", obj + "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
        return read_materials(parse_obj(read(path), path.string()), path, notices);
    }
    std::vector<Material> read_for(const std::string& obj) { return read_all(obj).materials; }
    MaterialDescription look_of(const std::string& mtl) {
        write("a.mtl", "newmtl red\n" + mtl);
        return read_for("mtllib a.mtl\n")[0].look;
    }
    TextureFiles textures_of(const std::string& mtl) {
        write("sub/a.mtl", "newmtl red\n" + mtl);
        return read_all("mtllib sub/a.mtl\n").textures.at(0);
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

TEST_F(MaterialLibrary, ChoosesTheType) {
    const struct {
        const char* mtl;
        std::uint32_t type;
    } cases[] = {
        {"Kd 1 1 1\n", material_type<Matte>},
        {"Ks 0 0 0\nNs 500\nillum 3\n", material_type<Matte>},
        {"Ks 0 0.01 0\nNs 10\nillum 2\n", material_type<Plastic>},
        {"Ks 1 1 1\nNs 100\n", material_type<Plastic>},
        {"Ks 1 1 1\nNs 100.5\n", material_type<Mirror>},
        {"Ks 0.1 0 0\nNs 1\nillum 3\n", material_type<Mirror>},
        {"Ks 0.1 0 0\nNs 1\nillum 5\n", material_type<Mirror>},
        {"Ks 1 1 1\nNs 1\nillum 7\n", material_type<Plastic>},
        {"Ks 1 1 1\nNs 500\nillum 3\nKe 0 0 0.5\n", material_type<Emissive>},
        {"Ke -1 0 0\nKs -1 0 0\n", material_type<Matte>},
    };
    for (const auto& each : cases) EXPECT_EQ(look_of(each.mtl).type, each.type) << each.mtl;
}

TEST_F(MaterialLibrary, ReadsWhatTheTypesNeed) {
    const MaterialDescription look = look_of("Kd 0.1 0.2 0.3\nKs 2 0.5 -1\nNs 30\nKe 12 nan -1\n");
    EXPECT_EQ(look.diffuse, (Vec3{0.1f, 0.2f, 0.3f}));
    EXPECT_EQ(look.specular, (Vec3{1, 0.5f, 0}));
    EXPECT_EQ(look.exponent, 30.0f);
    EXPECT_EQ(look.emission, (Vec3{12, 0, 0}));
    EXPECT_EQ(look_of("Ns -5\n").exponent, 0.0f);
    EXPECT_EQ(look_of("Ns 1e99\n").exponent, 0.0f);  // no float
}

TEST_F(MaterialLibrary, FindsImagesBesideTheirMtlFile) {
    const TextureFiles files = textures_of("map_Kd tex\\wood one.png \nmap_d ../mask.png\n");
    EXPECT_EQ(files.color.lexically_normal(), folder / "sub/tex/wood one.png");
    EXPECT_EQ(files.mask.lexically_normal(), folder / "mask.png");
    EXPECT_FALSE(textures_of("Kd 1 1 1\n").any());
}

TEST_F(MaterialLibrary, RefusesImagesOutsideTheFolder) {
    EXPECT_ERROR(textures_of("map_Kd ../../x.png\n"), ExitCode::usage,
                 "material \"red\": its texture \"../../x.png\" is outside");
    EXPECT_ERROR(textures_of("map_Kd ..\\..\\x.png\n"), ExitCode::usage, "is outside");
    EXPECT_ERROR(textures_of("map_d /etc/x.png\n"), ExitCode::usage, "is outside");
}

TEST_F(MaterialLibrary, APipeIsNotWaitedFor) {
    ASSERT_EQ(::mkfifo((folder / "a.mtl").c_str(), 0600), 0);
    read_for("mtllib a.mtl\n");
    EXPECT_TRUE(has_notice(notices, "\"a.mtl\" cannot be read"));
}

TEST_F(MaterialLibrary, RefusesMoreMaterialsThanFitIntoMemory) {
    std::string statements;
    for (int i = 0; i < 50'001; ++i) statements += "newmtl a\n";
    write("a.mtl", statements);
    EXPECT_ERROR(read_for("mtllib a.mtl\n"), ExitCode::usage,
                 "material library \"a.mtl\": a mesh has more than 50000 materials with it");
    const fs::path large = write("b.mtl", "newmtl a\n");
    fs::resize_file(large, (std::uintmax_t{64} << 20) + 1);  // a hole: it takes no space
    EXPECT_ERROR(read_for("mtllib b.mtl\n"), ExitCode::usage, "\"b.mtl\" has 67108865 bytes");
}

TEST_F(MaterialLibrary, FacesBeforeAnyMaterialAreGreyWithoutANotice) {
    const auto mesh = parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj");
    const auto materials = read_materials(mesh, "a.obj", notices).materials;
    ASSERT_EQ(materials.size(), 1u);
    EXPECT_EQ(materials[0].name, "default");
    EXPECT_TRUE(notices.empty());
}

}  // namespace
}  // namespace ctpbench
