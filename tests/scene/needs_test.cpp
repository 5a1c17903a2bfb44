#include "scene/needs.h"

#include <gtest/gtest.h>

#include "looks.h"
#include "support.h"

namespace ctpbench::test {
namespace {

constexpr std::uint32_t kTriangle = 1u << 0, kSphere = 1u << 1;  // as primitives/list.h has them

template <class... Types>
constexpr std::uint32_t bits = (0u | ... | (1u << material_type<Types>));

// Materials of all types, the last with a texture; the triangles have the first of them.
Scene sample() {
    Scene scene = soup(4, 0, 1);
    scene.materials = {{"a", matte(gray(0.5f))},
                       {"b", plastic(gray(0.4f), gray(0.1f), 9)},
                       {"c", mirror(gray(0.9f))},
                       {"d", emissive(gray(1))},
                       {"e", matte(gray(0.5f))}};
    scene.materials[4].look.texture = {0, 1, 1};
    scene.texels.resize(1);
    scene.sphere_material = 2;
    return scene;
}

TEST(SceneNeeds, AreOfWhatIsUsed) {
    Scene scene = sample();
    EXPECT_EQ(needs_of(scene), (SceneNeeds{kTriangle, bits<Matte>, false}));
    scene.mesh.material = {0, 3, 1, 0};
    EXPECT_EQ(needs_of(scene), (SceneNeeds{kTriangle, bits<Matte, Plastic, Emissive>, false}));
}

TEST(SceneNeeds, SpheresCountWithTheirMaterialIfThereAreAny) {
    Scene scene = sample();
    scene.spheres.push_back({{0, 0, 0}, 1});
    EXPECT_EQ(needs_of(scene), (SceneNeeds{kTriangle | kSphere, bits<Matte, Mirror>, false}));
    scene.mesh = {};
    EXPECT_EQ(needs_of(scene), (SceneNeeds{kSphere, bits<Mirror>, false}));
    scene.spheres.clear();
    EXPECT_EQ(needs_of(scene), SceneNeeds{});
}

TEST(SceneNeeds, ATextureCountsIfItsMaterialIsUsed) {
    Scene scene = sample();
    EXPECT_FALSE(needs_of(scene).textured);
    scene.mesh.material[3] = 4;
    EXPECT_TRUE(needs_of(scene).textured);
}

}  // namespace
}  // namespace ctpbench::test
