#include "scene/obj_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/scene/files.h"

namespace ctpbench {
namespace {

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

ObjMesh parse(const std::string& text) { return parse_obj(text, "a.obj"); }

void expect_usage_error(const std::string& text, const std::string& part) {
    EXPECT_ERROR(parse(text), ExitCode::usage, part);
}

TEST(ObjMesh, ReadsVerticesTrianglesAndNames) {
    const ObjMesh obj = parse("mtllib a.mtl b.mtl\n" + kTriangle +
                              "vt 0 0\nvt 1 0\nvt 0 1\nf 1 2 3\nusemtl red\nf 1/1 2/2 3/3\nusemtl blue \n" +
                              "f -3//1 -2//1 -1//1\nusemtl red\nf 3/1/2 2/1/2 1/1/2\n");
    ASSERT_EQ(obj.mesh.positions.size(), 3u);
    EXPECT_EQ(obj.mesh.positions[1], (Vec3{1, 0, 0}));
    ASSERT_EQ(obj.mesh.triangles.size(), 4u);
    EXPECT_EQ(obj.mesh.triangles[2], (std::array<std::uint32_t, 3>{0, 1, 2}));
    EXPECT_EQ(obj.mesh.triangles[3], (std::array<std::uint32_t, 3>{2, 1, 0}));
    EXPECT_EQ(obj.mesh.material, (std::vector<std::uint32_t>{0, 1, 2, 1}));
    ASSERT_EQ(obj.materials.size(), 3u);
    EXPECT_EQ(obj.materials[0].name, "");
    EXPECT_EQ(obj.materials[1].name, "red");
    EXPECT_EQ(obj.materials[1].line, 9u);
    EXPECT_EQ(obj.materials[2].name, "blue");
    ASSERT_EQ(obj.libraries.size(), 2u);
    EXPECT_EQ(obj.libraries[1].name, "b.mtl");
}

TEST(ObjMesh, ReadsNumbersExactly) {
    const ObjMesh obj =
        parse("v 0.1 -2.5e-3 +16777217\r\n\tv 1e-50 5.877e-39 1e+2 0.5 # w\r\nv 3 1 4 1 5 9\r\nf 1 2 3");
    EXPECT_EQ(obj.mesh.positions[0], (Vec3{0.1f, -2.5e-3f, 16777216.0f}));
    EXPECT_EQ(obj.mesh.positions[1], (Vec3{0.0f, 5.877e-39f, 100.0f}));
    EXPECT_EQ(obj.mesh.positions[2], (Vec3{3, 1, 4}));
    EXPECT_EQ(obj.mesh.triangles.size(), 1u);
}

TEST(ObjMesh, RefusesWhatIsNoMesh) {
    expect_usage_error("", "a.obj: the OBJ file is empty");
    expect_usage_error("# only a comment\n", "a.obj: no faces");
    expect_usage_error(kTriangle, "a.obj: no faces");
    expect_usage_error(std::string("\x1f\x8b\x08\0\0\0\xff\xff\n\0", 10), "no faces");
}

TEST(ObjMesh, NamesTheLineOfABrokenVertex) {
    expect_usage_error("v 0 0 0\nv 1 0\n", "a.obj:2: a vertex needs three numbers (\"v 1 0\")");
    expect_usage_error("v 0 0 0\n\n# x\nv 1 x 0\n", "a.obj:4: a vertex needs three numbers");
    expect_usage_error("v 1,5 0 0\n", "a.obj:1: a vertex needs three numbers");
    expect_usage_error("v 1 - 0\n", "a.obj:1: a vertex needs three numbers");
}

TEST(ObjMesh, NamesTheLineOfABrokenFace) {
    expect_usage_error(kTriangle + "f 1 2 4\n",
                       "a.obj:4: a face uses vertex 4, but 3 vertices are defined above it");
    expect_usage_error(kTriangle + "f -4 -2 -1\n", "a.obj:4: a face uses vertex -4");
    expect_usage_error(kTriangle + "f 1 2 0\n", "a.obj:4: a face's vertex index is 0 or no number");
    expect_usage_error(kTriangle + "f 1 2 x\n", "a.obj:4: a face's vertex index is 0 or no number");
    expect_usage_error(kTriangle + "f 1 2\n", "a.obj:4: a face needs three vertices");
    expect_usage_error(kTriangle + "f 1 2 2147483647\n", "a.obj:4: a face uses vertex 2147483647");
    expect_usage_error(kTriangle + "f 1 2 -2147483648\n", "a.obj:4: a face uses vertex -2147483648");
    expect_usage_error("f 1 2 3\n" + kTriangle, "a.obj:1: a face uses vertex 1, but 0 vertices");
}

TEST(ObjMesh, DropsTrianglesThatCannotBeHit) {
    const ObjMesh obj = parse(kTriangle + "v nan 0 0\nv 0 inf 0\nv 0 0 1e19\nv 1e39 0 0\nv 2 0 0\n" +
                              "f 1 2 3\nf 1 2 4\nf 1 2 5\nf 1 2 6\nf 1 2 7\nf 1 2 2\nf 1 2 8\nf 3 2 1\n");
    EXPECT_EQ(obj.mesh.triangles.size(), 2u);
    EXPECT_EQ(obj.mesh.material.size(), 2u);
    EXPECT_EQ(obj.dropped.bad_vertex, 4u);
    EXPECT_EQ(obj.dropped.zero_area, 2u);
    EXPECT_EQ(obj.dropped.first_line, 10u);
}

TEST(ObjMesh, RefusesAMeshOfWhichNothingIsLeft) {
    expect_usage_error("v nan nan nan\nv 0 0 0\nf 2 2 2\nf 1 1 2\n",
                       "a.obj: none of its 2 triangles can be used");
}

TEST(ObjMesh, KeepsTinyAndHugeTriangles) {
    const ObjMesh obj =
        parse("v 0 0 0\nv 1e-38 0 0\nv 0 1e-38 0\nv 9e17 0 0\nv 0 9e17 0\nf 1 2 3\nf 1 4 5\n");
    EXPECT_EQ(obj.mesh.triangles.size(), 2u);
    EXPECT_EQ(obj.dropped.total(), 0u);
}

TEST(ObjMesh, TriangulatesPolygons) {
    const ObjMesh obj = parse("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv -1 0.5 0\nf 1 2 3 4\nf 1 2 3 4 5\n");
    ASSERT_EQ(obj.mesh.triangles.size(), 5u);
    EXPECT_EQ(obj.mesh.triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
    EXPECT_EQ(obj.mesh.triangles[1], (std::array<std::uint32_t, 3>{0, 2, 3}));
}

const std::string kTexcoords = "vt 0.25 0.5\nvt 1 0 9\nvt -3.5\n";

void expect_uv(Vec2 uv, float u, float v) {
    EXPECT_EQ(uv.x, u);
    EXPECT_EQ(uv.y, v);
}

TEST(ObjMesh, ReadsTextureCoordinatesParallelToTheTriangles) {
    const ObjMesh obj = parse(kTriangle + "f 1 2 3\n" + kTexcoords +
                              "f 1/1 2/2 3/3\nf 1/-1/1 2/-2/1 3\nf 1 1 2\nf 1//1 2//1 3//1\n");
    ASSERT_EQ(obj.mesh.triangles.size(), 4u);
    ASSERT_EQ(obj.mesh.texcoords.size(), 4u);
    for (const std::size_t without : {0, 3}) {
        for (const Vec2 uv : obj.mesh.texcoords[without]) expect_uv(uv, 0, 0);
    }
    expect_uv(obj.mesh.texcoords[1][0], 0.25f, 0.5f);
    expect_uv(obj.mesh.texcoords[1][1], 1, 0);
    expect_uv(obj.mesh.texcoords[1][2], -3.5f, 0);  // a `vt` may have one number
    expect_uv(obj.mesh.texcoords[2][0], -3.5f, 0);
    expect_uv(obj.mesh.texcoords[2][1], 1, 0);
    expect_uv(obj.mesh.texcoords[2][2], 0, 0);
    EXPECT_EQ(obj.bad_texcoords.count, 0u);
}

TEST(ObjMesh, HasNoTextureCoordinatesUnlessAFaceNamesSome) {
    EXPECT_TRUE(parse(kTriangle + kTexcoords + "f 1 2 3\n").mesh.texcoords.empty());
    EXPECT_TRUE(parse(kTriangle + "f 1 2 3\n").mesh.texcoords.empty());
}

// A slit polygon visits the positions 1 and 5 twice, with other coordinates each time; they are the corner's
// number. So a triangle's vertices must be the positions of the corners that its coordinates name.
TEST(ObjMesh, PolygonsKeepTheCoordinatesOfTheirCorners) {
    const std::vector<int> corners = {1, 2, 3, 4, 1, 5, 6, 7, 8, 5};
    std::string text = "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 1 2 0\nv 2 2 0\nv 2 1 0\n";
    std::string face = "f";
    for (std::size_t i = 0; i < corners.size(); ++i) {
        text += "vt " + std::to_string(i) + " 0\n";
        face += " " + std::to_string(corners[i]) + "/" + std::to_string(i + 1);
    }
    const ObjMesh obj = parse(text + face + "\n");
    ASSERT_EQ(obj.mesh.triangles.size(), 8u);
    std::vector<int> uses(corners.size());
    for (std::size_t i = 0; i < obj.mesh.triangles.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            const auto corner = static_cast<std::size_t>(obj.mesh.texcoords[i][k].x);
            EXPECT_EQ(obj.mesh.triangles[i][k] + 1, static_cast<std::uint32_t>(corners[corner]));
            ++uses[corner];
        }
    }
    EXPECT_EQ(std::count(uses.begin(), uses.end(), 0), 0);  // each corner is one of some triangle
}

TEST(ObjMesh, CountsBrokenTextureCoordinates) {
    const ObjMesh obj = parse(kTriangle + "vt nan 0\nvt 0 inf\nvt x 1\nvt \nvt 1e19 0\nvt 0.5 0.5\n" +
                              "f 1/1 2/2 3/6\nf 1/3 2/4 3/5\n");
    EXPECT_EQ(obj.bad_texcoords.count, 5u);
    EXPECT_EQ(obj.bad_texcoords.first_line, 4u);
    expect_uv(obj.mesh.texcoords[0][0], 0, 0);
    expect_uv(obj.mesh.texcoords[0][1], 0, 0);
    expect_uv(obj.mesh.texcoords[0][2], 0.5f, 0.5f);
    for (const Vec2 uv : obj.mesh.texcoords[1]) expect_uv(uv, 0, 0);
}

TEST(ObjMesh, NamesTheLineOfABrokenTextureIndex) {
    expect_usage_error(kTriangle + "vt 0 0\nf 1/1 2/2 3/1\n",
                       "a.obj:5: a face uses texture coordinate 2, but 1 texture coordinates are defined");
    expect_usage_error(kTriangle + "vt 0 0\nf 1/1 2/-2 3/1\n", "a.obj:5: a face uses texture coordinate -2");
    expect_usage_error(kTriangle + "f 1/1 2/1 3/1\nvt 0 0\n", "a.obj:4: a face uses texture coordinate 1");
    expect_usage_error(kTriangle + "vt 0 0\nf 1/2147483647 2 3\n", "texture coordinate 2147483647");
}

// The worst for cutting ears: a comb, whose corners are blocked by each other.
TEST(ObjMesh, BoundsThePolygonsItCuts) {
    const auto comb = [](int corners) {
        std::string text, face = "f";
        for (int i = 0; i < corners; ++i) {
            const int tooth = i < corners / 2 ? i : corners - 1 - i;
            text += "v " + std::to_string(tooth) + " " +
                    std::to_string(tooth % 2 * 1000 + (i < corners / 2 ? 0 : 1)) + " 0\n";
            face += " " + std::to_string(i + 1);
        }
        return text + face + "\n";
    };
    EXPECT_GT(parse(comb(2000)).mesh.triangles.size(), 1000u);
    expect_usage_error(comb(2001), "a.obj:2002: a face of 2001 corners; 2000 are the most");
}

TEST(ObjMesh, BoundsItsLibraries) {
    std::string names;
    for (int i = 0; i < 1001; ++i) names += "mtllib " + std::to_string(i) + ".mtl\n";
    expect_usage_error(names + kTriangle + "f 1 2 3\n", "a.obj:1001: error: names more than 1000 material");
}

TEST(ObjMesh, SkipsWhatItDoesNotNeed) {
    const ObjMesh obj =
        parse("o thing\ng a b\ns 1\nvn 0 0 1\nvt 0 0\n" + kTriangle + "l 1 2\np 1\nf 1 2 3\nunknown x\n");
    EXPECT_EQ(obj.mesh.triangles.size(), 1u);
}

}  // namespace
}  // namespace ctpbench
