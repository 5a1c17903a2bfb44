// Images that the test writes itself, so it needs OpenImageIO; without it only the last test runs.
#include "scene/textures.h"

#include <sys/stat.h>

#include <cmath>

#include "kernels/materials/list.h"
#include "scene/load_scene.h"
#include "scene/texture_image.h"
#include "tests/scene/files.h"

#ifdef CTPBENCH_HAS_OPENIMAGEIO
#include <OpenImageIO/imageio.h>
#endif

namespace ctpbench {
namespace {

const std::string kTexturedObj =
    "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3\n"
    "usemtl b\nf 3/3 2/2 1/1\n";

class Textures : public SceneFiles {
protected:
    Scene load(const std::string& mtl, const std::string& obj = kTexturedObj) {
        write("a.mtl", mtl);
        SceneRequest request;
        request.name = write("a.obj", obj).string();
        return load_scene(request, notices);
    }
};

#ifdef CTPBENCH_HAS_OPENIMAGEIO

constexpr std::uint16_t kOne = 65535;

std::uint16_t from_srgb(int byte) {
    const double v = byte / 255.0;
    return static_cast<std::uint16_t>(
        std::lround(65535.0 * (v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4))));
}

class TextureImages : public Textures {
protected:
    // Rows from the top down, as image files have them. Alpha is written as given, next to the colours.
    template <class T>
    fs::path write_image(const std::string& name, int width, int height, int channels,
                         const std::vector<T>& values) {
        const fs::path path = folder / name;
        OIIO::ImageSpec spec(width, height, channels, OIIO::BaseTypeFromC<T>::value);
        if (name.ends_with(".png")) spec.attribute("oiio:UnassociatedAlpha", 1);
        const auto out = OIIO::ImageOutput::create(path.string());
        EXPECT_TRUE(out && out->open(path.string(), spec) &&
                    out->write_image(OIIO::BaseTypeFromC<T>::value, values.data()) && out->close());
        return path;
    }
    TextureImage color(const fs::path& path) { return read_color_image(path, why).value(); }
    TextureImage mask(const fs::path& path) { return read_mask_image(path, why).value(); }

    static void expect_texel(const Texel& t, int r, int g, int b, int a) {
        EXPECT_EQ(t.r, r);
        EXPECT_EQ(t.g, g);
        EXPECT_EQ(t.b, b);
        EXPECT_EQ(t.a, a);
    }

    std::string why;
};

using Bytes = std::vector<unsigned char>;

TEST_F(TextureImages, RowsComeFromTheBottomUp) {
    const TextureImage image =
        color(write_image("a.png", 2, 2, 3, Bytes{255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255}));
    ASSERT_EQ(image.texels.size(), 4u);
    expect_texel(image.texels[0], 0, 0, kOne, kOne);
    expect_texel(image.texels[1], kOne, kOne, kOne, kOne);
    expect_texel(image.texels[2], kOne, 0, 0, kOne);
    expect_texel(image.texels[3], 0, kOne, 0, kOne);
}

TEST_F(TextureImages, EightBitColoursAreDecodedAndAlphaIsNot) {
    const TextureImage image = color(write_image("a.png", 2, 1, 4, Bytes{1, 10, 128, 77, 188, 254, 200, 0}));
    expect_texel(image.texels[0], from_srgb(1), from_srgb(10), from_srgb(128), 77 * 257);
    expect_texel(image.texels[1], from_srgb(188), from_srgb(254), from_srgb(200), 0);
    EXPECT_NEAR(image.texels[0].b / 65535.0, 0.2158605, 1e-5);  // sRGB 128
}

TEST_F(TextureImages, FloatingPointIsLinearAndClamped) {
    const TextureImage image =
        color(write_image("a.exr", 2, 1, 3, std::vector<float>{0.5f, 2.0f, -1.0f, 0.25f, NAN, 1.0f}));
    expect_texel(image.texels[0], 32768, kOne, 0, kOne);
    expect_texel(image.texels[1], 16384, 0, kOne, kOne);
}

// OpenEXR's colours are multiplied by alpha.
TEST_F(TextureImages, AssociatedColoursAreDividedByAlpha) {
    const TextureImage image =
        color(write_image("a.exr", 1, 1, 4, std::vector<float>{0.25f, 0.125f, 0.5f, 0.5f}));
    expect_texel(image.texels[0], 32768, 16384, kOne, 32768);
}

TEST_F(TextureImages, GreyWithAndWithoutAlpha) {
    const int grey = from_srgb(100);
    expect_texel(color(write_image("a.png", 1, 1, 1, Bytes{100})).texels[0], grey, grey, grey, kOne);
    expect_texel(color(write_image("b.png", 1, 1, 2, Bytes{100, 51})).texels[0], grey, grey, grey, 51 * 257);
}

TEST_F(TextureImages, AMaskIsItsAlphaOrElseItsFirstChannelAsItStands) {
    EXPECT_EQ(mask(write_image("a.png", 1, 1, 1, Bytes{128})).texels[0].a, 128 * 257);
    EXPECT_EQ(mask(write_image("b.png", 1, 1, 3, Bytes{128, 0, 0})).texels[0].a, 128 * 257);
    EXPECT_EQ(mask(write_image("c.png", 1, 1, 4, Bytes{128, 0, 0, 64})).texels[0].a, 64 * 257);
    EXPECT_EQ(mask(write_image("d.png", 1, 1, 4, Bytes{128, 0, 0, 255})).texels[0].a, 128 * 257);
    expect_texel(mask(folder / "a.png").texels[0], kOne, kOne, kOne, 128 * 257);
}

TEST_F(TextureImages, AMaskOfAnotherSizeIsMergedInTheLargerOfEach) {
    const TextureImage image = color(write_image("a.png", 4, 1, 3, Bytes(12, 255)));
    const TextureImage alpha = mask(write_image("b.png", 1, 2, 1, Bytes{255, 0}));  // the bottom is 0
    const TextureImage merged = with_mask(image, alpha);
    ASSERT_EQ(merged.width, 4u);
    ASSERT_EQ(merged.height, 2u);
    for (std::size_t i = 0; i < 8; ++i) {
        expect_texel(merged.texels[i], kOne, kOne, kOne, i < 4 ? 0 : kOne);
    }
    // Twice as many: bilinear, repeated.
    const TextureImage finer = with_mask(color(write_image("c.png", 1, 4, 3, Bytes(12, 0))), alpha);
    const int expected[] = {16384, 16384, 49151, 49151};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(finer.texels[i].a, expected[i], 1);
}

TEST_F(TextureImages, AnUnreadableFileSaysWhy) {
    EXPECT_FALSE(read_color_image(folder / "gone.png", why));
    EXPECT_EQ(why, "no such file");
    EXPECT_FALSE(read_mask_image(write("a.png", "no image"), why));
    EXPECT_FALSE(why.empty());
    EXPECT_FALSE(read_color_image(folder, why));
}

TEST_F(TextureImages, TooWideAnImageIsAnError) {
    EXPECT_ERROR(read_color_image(write_image("a.png", 65536, 1, 1, Bytes(65536)), why), ExitCode::usage,
                 "a.png: error: the texture has 65536 x 1 pixels; 65535 a side and 2^28 in all are the most");
}

// Of a header alone: Netpbm's says the size in words.
TEST_F(TextureImages, AHeaderThatClaimsTooMuchIsAnErrorBeforeAnythingIsRead) {
    EXPECT_ERROR(read_color_image(write("a.ppm", "P6\n60000 60000\n255\n"), why), ExitCode::usage,
                 "a.ppm: error: the texture has 60000 x 60000 pixels; 65535 a side and 2^28");
    EXPECT_ERROR(read_mask_image(write("b.pgm", "P5\n60000 60000\n255\n"), why), ExitCode::usage,
                 "b.pgm: error: the texture has 60000 x 60000 pixels");
    EXPECT_FALSE(read_color_image(write("c.ppm", "P6\n64 64\n255\nabc"), why));
}

TEST_F(TextureImages, AMaskThatMakesItTooLargeIsAnError) {
    const TextureImage wide{20000, 1, std::vector<Texel>(20000)}, high{1, 20000, std::vector<Texel>(20000)};
    EXPECT_ERROR(with_mask(wide, high), ExitCode::usage,
                 "20000 x 1 pixels and its mask of 1 x 20000 have more than 2^28 together");
}

TEST_F(TextureImages, ChannelsBehindColoursAndAlphaAreLeftOut) {
    const TextureImage image = color(write_image("a.tif", 1, 1, 6, Bytes{255, 0, 255, 255, 0, 0}));
    expect_texel(image.texels[0], kOne, 0, kOne, kOne);
}

TEST_F(TextureImages, APipeIsNoImage) {
    ASSERT_EQ(::mkfifo((folder / "pipe.png").c_str(), 0600), 0);
    EXPECT_FALSE(read_color_image(folder / "pipe.png", why));
    EXPECT_FALSE(read_color_image("/dev/zero", why));
}

TEST_F(TextureImages, MaterialsShareAPairAndKdStays) {
    write_image("c.png", 2, 1, 3, Bytes{255, 0, 0, 0, 0, 255});
    write_image("m.png", 1, 1, 1, Bytes{51});
    const Scene scene = load(
        "newmtl a\nKd 0.25 0.5 1\nmap_Kd c.png\nmap_d m.png\n"
        "newmtl b\nKs 0.1 0.1 0.1\nmap_Kd c.png\nmap_d m.png\n");
    EXPECT_TRUE(notices.empty());
    ASSERT_EQ(scene.texels.size(), 2u);
    expect_texel(scene.texels[0], kOne, 0, 0, 51 * 257);
    const MaterialDescription &a = scene.materials[0].look, &b = scene.materials[1].look;
    EXPECT_EQ(a.diffuse, (Vec3{0.25f, 0.5f, 1}));
    EXPECT_EQ(b.type, material_type<Plastic>);
    for (const MaterialDescription* look : {&a, &b}) {
        EXPECT_EQ(look->texture.first, 0u);
        EXPECT_EQ(look->texture.width, 2u);
        EXPECT_EQ(look->texture.height, 1u);
    }
    ASSERT_EQ(scene.mesh.texcoords.size(), 2u);
    EXPECT_EQ(scene.mesh.texcoords[1][0].y, 1.0f);
}

TEST_F(TextureImages, TexturesFollowEachOtherInTheArena) {
    write_image("c.png", 2, 3, 3, Bytes(18, 255));
    write_image("m.png", 1, 1, 1, Bytes{51});
    const Scene scene = load("newmtl a\nmap_Kd c.png\nnewmtl b\nmap_d m.png\n");
    ASSERT_EQ(scene.texels.size(), 7u);
    EXPECT_EQ(scene.materials[1].look.texture.first, 6u);
    expect_texel(scene.texels[6], kOne, kOne, kOne, 51 * 257);  // a mask alone is on white
}

TEST_F(TextureImages, MirrorsAndLampsHaveNone) {
    write_image("c.png", 1, 1, 3, Bytes{255, 0, 0});
    const Scene scene = load("newmtl a\nKs 1 1 1\nillum 3\nmap_Kd c.png\nnewmtl b\nKe 1 1 1\nmap_Kd c.png\n");
    EXPECT_FALSE(scene.materials[0].look.texture.exists());
    EXPECT_FALSE(scene.materials[1].look.texture.exists());
    EXPECT_TRUE(scene.texels.empty());
    EXPECT_TRUE(scene.mesh.texcoords.empty());
    EXPECT_TRUE(notices.empty());
}

TEST_F(TextureImages, OverriddenTypesDecide) {
    write_image("c.png", 1, 1, 3, Bytes{255, 0, 0});
    write("a.mtl", "newmtl a\nmap_Kd c.png\nnewmtl b\nKe 1 1 1\nmap_Kd c.png\n");
    write("a.obj", kTexturedObj);
    SceneRequest request;
    request.name = write("a.json", R"({"schema_version": 1, "name": "a", "mesh": {"file": "a.obj"},
        "overrides": {"materials": {"a": {"type": "mirror"}, "b": {"type": "plastic"}}}})")
                       .string();
    const Scene scene = load_scene(request, notices);
    EXPECT_FALSE(scene.materials[0].look.texture.exists());
    EXPECT_TRUE(scene.materials[1].look.texture.exists());
}

// Neither of a material without faces, nor of one whose only face is dropped. An image that cannot be read
// would be noticed.
TEST_F(TextureImages, OfUnusedMaterialsAreNotRead) {
    write_image("c.png", 2, 1, 3, Bytes(6, 255));
    const std::string mtl =
        "newmtl a\nmap_Kd c.png\nnewmtl b\nnewmtl c\nmap_Kd gone.png\nnewmtl d\nmap_d bad.png\n";
    const Scene scene = load(mtl, kTexturedObj + "usemtl c\nusemtl d\nf 1/1 1/1 2/2\n");
    EXPECT_FALSE(has_notice(notices, "could not be read"));
    EXPECT_EQ(scene.texels.size(), 2u);
    EXPECT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.savings.unused_materials, 2u);
    EXPECT_EQ(scene.savings.unused_texcoords, 0u);
    load(mtl, kTexturedObj + "usemtl c\nf 1/1 2/2 3/3\n");
    EXPECT_TRUE(has_notice(notices, "gone.png (no such file); 1 image could not be read"));
}

TEST_F(TextureImages, CoordinatesStayForAUsedMaterialsTextureOnly) {
    write_image("c.png", 1, 1, 3, Bytes{255, 0, 0});
    const Scene without = load("newmtl a\nnewmtl b\nnewmtl c\nmap_Kd c.png\n", kTexturedObj + "usemtl c\n");
    EXPECT_TRUE(without.mesh.texcoords.empty());
    EXPECT_TRUE(without.texels.empty());
    EXPECT_EQ(without.savings.unused_texcoords, 2u);
}

// Materials with the same files behave alike; those with others do not.
TEST_F(TextureImages, MaterialsOfOneTextureAreOne) {
    for (const char* name : {"c.png", "other.png"}) write_image(name, 1, 1, 3, Bytes{255, 0, 0});
    EXPECT_EQ(load("newmtl a\nmap_Kd c.png\nnewmtl b\nmap_Kd c.png\n").materials.size(), 1u);
    EXPECT_EQ(load("newmtl a\nmap_Kd c.png\nnewmtl b\nmap_Kd other.png\n").materials.size(), 2u);
}

TEST_F(TextureImages, MissingImagesAreOneNotice) {
    write_image("c.png", 1, 1, 3, Bytes{255, 0, 0});
    const Scene scene =
        load("newmtl a\nmap_Kd gone.png\nmap_d bad.png\nnewmtl b\nmap_Kd c.png\nmap_d gone.png\n");
    ASSERT_EQ(notices.size(), 1u);
    EXPECT_TRUE(has_notice(notices, "gone.png (no such file); 2 images could not be read"));
    EXPECT_FALSE(scene.materials[0].look.texture.exists());
    EXPECT_TRUE(scene.materials[1].look.texture.exists());
    expect_texel(scene.texels.at(0), kOne, 0, 0, kOne);
}

TEST_F(TextureImages, AMeshWithoutCoordinatesHasNone) {
    write_image("c.png", 1, 1, 3, Bytes{255, 0, 0});
    const Scene scene =
        load("newmtl a\nmap_Kd c.png\n", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
    EXPECT_FALSE(scene.materials[0].look.texture.exists());
    EXPECT_TRUE(has_notice(notices, "1 material names textures, but the mesh has no texture coordinates"));
}

#else

TEST_F(Textures, AreLeftOutWithoutOpenImageIo) {
    const Scene scene = load("newmtl a\nmap_Kd c.png\nnewmtl b\nmap_d c.png\n");
    EXPECT_TRUE(has_notice(notices, "2 materials name textures, which are left out"));
    EXPECT_TRUE(has_notice(notices, "libopenimageio-dev"));
    EXPECT_TRUE(scene.texels.empty());
    GTEST_SKIP() << "the other tests of textures need OpenImageIO";
}

#endif

TEST_F(Textures, CoordinatesAreDroppedWithoutATexture) {
    EXPECT_TRUE(load("newmtl a\nnewmtl b\n").mesh.texcoords.empty());
    EXPECT_TRUE(notices.empty());
}

}  // namespace
}  // namespace ctpbench
