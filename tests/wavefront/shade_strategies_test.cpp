// The shade stage's invariant: the image is a function of scene, seed and samples alone. Every shade
// strategy, whatever it does to the order of its paths, and any number of threads give it bit for bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "support.h"
#include "wavefront/frames.h"

namespace ctpbench {
namespace {

Material material(std::uint32_t type, Vec3 diffuse, Vec3 specular = {0, 0, 0}, float exponent = 0) {
    Material m;
    m.look.type = type, m.look.diffuse = diffuse, m.look.specular = specular, m.look.exponent = exponent;
    return m;
}

// A soup of triangles and spheres with all four types, textured and not, some of it cut out by alpha.
Scene motley() {
    Scene scene = test::soup(3000, 60, 11);
    scene.materials = {material(material_type<Matte>, {0.8f, 0.5f, 0.3f}),
                       material(material_type<Plastic>, {0.4f, 0.4f, 0.6f}, {0.3f, 0.3f, 0.3f}, 60),
                       material(material_type<Mirror>, {0, 0, 0}, {0.9f, 0.8f, 0.7f}),
                       material(material_type<Emissive>, {0, 0, 0}),
                       material(material_type<Matte>, {1, 1, 1}),
                       material(material_type<Plastic>, {0.9f, 0.9f, 0.9f}, {0.2f, 0.1f, 0.1f}, 5)};
    scene.materials[3].look.emission = {3, 2, 1};
    test::Random random(3);
    for (int i = 0; i < 7 * 5; ++i)
        scene.texels.push_back({static_cast<std::uint16_t>(random.uniform(0, 65535)),
                                static_cast<std::uint16_t>(random.uniform(0, 65535)),
                                static_cast<std::uint16_t>(random.uniform(0, 65535)),
                                static_cast<std::uint16_t>(i % 3 == 0 ? 0 : 65535)});
    scene.materials[4].look.texture = {0, 7, 5};
    scene.materials[5].look.texture = {14, 7, 3};
    for (std::size_t i = 0; i < scene.mesh.triangles.size(); ++i) {
        scene.mesh.material[i] = static_cast<std::uint32_t>(i % scene.materials.size());
        const auto corner = [&] { return Vec2{random.uniform(-2, 3), random.uniform(-2, 3)}; };
        scene.mesh.texcoords.push_back({corner(), corner(), corner()});
    }
    scene.sphere_material = 2;
    scene.ambient = {0.3f, 0.5f, 0.7f};
    return scene;
}

const Camera kCamera = test::looking_from({0.2f, 0.1f, 2.5f}, {0, 0, 0});
const FrameSettings kSettings{101, 67, 6, 9};

TEST(ShadeStrategies, GiveTheSameImageBitForBit) {
    const Scene scene = motley();
    std::uint64_t expected = 0;
    for (const int threads : {1, 2})
        for (const char* intersect : {"ctp", "restart", "typed_leaves"}) {
            test::Stage stage(scene, threads, intersect);
            for (const std::string& shade : shade_strategies()) {
                const test::Frames frames = test::render(stage, kCamera, kSettings, 3, shade);
                if (expected == 0) expected = frames.image.hash();
                EXPECT_EQ(frames.image.hash(), expected)
                    << shade << " after " << intersect << ", " << threads << " threads";
            }
        }
}

TEST(ShadeStrategies, CountTheSamePathsAndDroppedSamples) {
    const Scene scene = motley();
    test::Stage stage(scene, 2);
    std::vector<std::uint32_t> paths, dropped;
    for (const std::string& shade : shade_strategies()) {
        std::vector<std::uint32_t> its_paths, its_dropped;
        for (const StageTime& s : test::render(stage, kCamera, kSettings, 1, shade).stages) {
            if (std::string(s.kernel) != "shade") continue;
            its_paths.push_back(s.rays), its_dropped.push_back(s.dropped);
        }
        if (paths.empty()) paths = its_paths, dropped = its_dropped;
        EXPECT_EQ(its_paths, paths) << shade;
        EXPECT_EQ(its_dropped, dropped) << shade;
    }
    EXPECT_EQ(paths.size(), 7u);
    EXPECT_GT(*std::max_element(dropped.begin(), dropped.end()), 0u) << "the scene has glossy grazing angles";
}

// The scene is worth the test: each type is hit, textures matter, and so do their holes.
TEST(ShadeStrategies, AreTestedOnAllThatMaterialsDo) {
    const Scene scene = motley();
    test::Stage stage(scene, 2);
    std::map<std::uint32_t, int> seen;
    const std::uint64_t image =
        test::render(stage, kCamera, kSettings, 1, "ctp", [&](const BounceView& view) {
            for (const std::uint32_t slot : view.slots) {
                const std::uint32_t primitive = view.hits.primitive[slot];
                ++seen[primitive == kNoPrimitive ? kMissKey : stage.view.words().of(primitive).type()];
            }
        }).image.hash();
    for (std::uint32_t key = 0; key < kShadeKeys; ++key) EXPECT_GT(seen[key], 100) << key;

    const auto image_with = [&](auto change) {
        Scene other = motley();
        change(other);
        test::Stage other_stage(other, 2);
        return test::render(other_stage, kCamera, kSettings).image.hash();
    };
    EXPECT_NE(image, image_with([](Scene& s) { s.texels[1].g /= 2; }));
    EXPECT_NE(image, image_with([](Scene& s) {
                  for (Texel& t : s.texels) t.a = 65535;
              }));
    EXPECT_EQ(image, image_with([](Scene&) {}));
}

}  // namespace
}  // namespace ctpbench
