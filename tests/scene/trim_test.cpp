// What trimming must not change, on random scenes that are full of what it takes out, and what it must leave
// nothing of.
#include "scene/trim.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <set>
#include <string>

#include "looks.h"
#include "scene/content_hash.h"
#include "scene/needs.h"
#include "support.h"

namespace ctpbench::test {
namespace {

template <class T>
std::string bytes_of(const T& value) {
    std::string bytes(sizeof(T), '\0');
    std::memcpy(bytes.data(), &value, sizeof(T));
    return bytes;
}

// What a material is to whoever hits it.
std::string behaviour(const Material& material) {
    std::string bytes = bytes_of(material.look.type);
    for_each_type(Materials{}, [&](auto tag) {
        using T = typename decltype(tag)::type;
        if (material.look.type == material_type<T>) bytes += bytes_of(T::make(material.look));
    });
    return bytes;
}

MaterialDescription textured(MaterialDescription look, std::uint32_t first) {
    look.texture = {first, 2, 1};
    return look;
}

// Fifteen materials of at most nine behaviours, of which the triangles use some; 60 vertices, likewise.
// Scenes of even seeds have textures, and two in three have spheres.
Scene random_scene(std::uint64_t seed) {
    Random random(seed);
    const auto below = [&](std::size_t n) {
        return static_cast<std::uint32_t>(random.uniform(0, static_cast<float>(n)));
    };
    MaterialDescription shiny = matte(gray(0.5f));
    shiny.specular = gray(0.3f);  // which matte does not look at
    std::vector<MaterialDescription> looks = {matte(gray(0.5f)),
                                              shiny,
                                              matte(gray(0.25f)),
                                              plastic(gray(0.5f), gray(0.25f), 9),
                                              plastic(gray(0.5f), gray(0.25f), 10),
                                              mirror(gray(0.5f)),
                                              emissive(gray(0.5f))};
    if (seed % 2 == 0) {
        looks.push_back(textured(matte(gray(0.5f)), 0));
        looks.push_back(textured(matte(gray(0.5f)), 2));
    }
    Scene scene;
    for (int i = 0; i < 15; ++i)
        scene.materials.push_back({"m" + std::to_string(i), looks[below(looks.size())]});
    for (int i = 0; i < 60; ++i) scene.mesh.positions.push_back(random.point(-1, 1));
    for (int i = 0; i < 20; ++i) {
        scene.mesh.triangles.push_back({below(60), below(60), below(60)});
        scene.mesh.material.push_back(below(8));
        const auto corner = [&] { return Vec2{random.uniform(0, 1), random.uniform(0, 1)}; };
        scene.mesh.texcoords.push_back({corner(), corner(), corner()});
    }
    scene.texels = {{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}, {13, 14, 15, 16}};
    if (seed % 3 != 0) scene.spheres.push_back({random.point(-1, 1), 0.5f});
    do scene.sphere_material = below(15);
    while (scene.materials[scene.sphere_material].look.texture.exists());
    return scene;
}

class Trim : public testing::TestWithParam<std::uint64_t> {
protected:
    const Scene before = random_scene(GetParam());
    const Scene after = [](Scene scene) {
        trim(scene);
        return scene;
    }(before);
};

TEST_P(Trim, WhatCanBeHitIsAsBefore) {
    ASSERT_EQ(after.mesh.triangles.size(), before.mesh.triangles.size());
    ASSERT_EQ(after.mesh.material.size(), before.mesh.material.size());
    const bool has_texcoords = !after.mesh.texcoords.empty();
    for (std::size_t i = 0; i < before.mesh.triangles.size(); ++i) {
        EXPECT_EQ(bytes_of(after.mesh.triangle(i)), bytes_of(before.mesh.triangle(i))) << i;
        const Material& was = before.materials[before.mesh.material[i]];
        EXPECT_EQ(behaviour(after.materials.at(after.mesh.material[i])), behaviour(was)) << i;
        EXPECT_TRUE(has_texcoords || !was.look.texture.exists()) << i;
        if (!has_texcoords) continue;
        EXPECT_EQ(bytes_of(after.mesh.texcoords[i]), bytes_of(before.mesh.texcoords[i])) << i;
    }
    ASSERT_LT(after.sphere_material, after.materials.size());
    ASSERT_EQ(after.spheres.size(), before.spheres.size());
    if (after.spheres.empty()) return;
    EXPECT_EQ(bytes_of(after.spheres[0]), bytes_of(before.spheres[0]));
    EXPECT_EQ(behaviour(after.materials[after.sphere_material]),
              behaviour(before.materials[before.sphere_material]));
}

TEST_P(Trim, LeavesNothingThatIsNotNeeded) {
    std::set<std::uint32_t> vertices;
    for (const auto& triangle : after.mesh.triangles) vertices.insert(triangle.begin(), triangle.end());
    EXPECT_EQ(vertices.size(), after.mesh.positions.size());
    EXPECT_EQ(*vertices.rbegin() + 1, after.mesh.positions.size());
    EXPECT_EQ(used_materials(after), std::vector<bool>(after.materials.size(), true));
    std::set<std::string> behaviours;
    for (const Material& m : after.materials) EXPECT_TRUE(behaviours.insert(behaviour(m)).second) << m.name;
    EXPECT_EQ(after.mesh.texcoords.empty(), !needs_of(before).textured);
    EXPECT_EQ(after.texels.empty(), !needs_of(before).textured);
}

TEST_P(Trim, NeedsStayAsTheyAre) { EXPECT_EQ(needs_of(after), needs_of(before)); }

TEST_P(Trim, TheOrderStays) {
    const auto in_order = [](const auto& kept, const auto& all, auto&& same) {
        std::size_t found = 0;
        for (const auto& one : all) found += found < kept.size() && same(kept[found], one) ? 1 : 0;
        return found == kept.size();
    };
    EXPECT_TRUE(in_order(after.mesh.positions, before.mesh.positions, [](Vec3 a, Vec3 b) { return a == b; }));
    EXPECT_TRUE(in_order(after.materials, before.materials,
                         [](const Material& a, const Material& b) { return a.name == b.name; }));
}

TEST_P(Trim, CountsWhatItTakesOut) {
    const SceneSavings& savings = after.savings;
    EXPECT_EQ(savings.unused_vertices, before.mesh.positions.size() - after.mesh.positions.size());
    EXPECT_EQ(savings.unused_texcoords, before.mesh.texcoords.size() - after.mesh.texcoords.size());
    const std::vector<bool> used = used_materials(before);
    const auto unused = static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
    EXPECT_EQ(savings.unused_materials, unused);
    EXPECT_EQ(savings.merged_materials, before.materials.size() - unused - after.materials.size());
    EXPECT_GT(savings.unused_vertices, 0u);  // or the tests of this file show little
    EXPECT_GT(savings.unused_materials, 0u);
}

TEST_P(Trim, ASecondTimeTakesOutNothing) {
    Scene again = after;
    trim(again);
    EXPECT_EQ(content_hash(again), content_hash(after));
    EXPECT_EQ(again.savings, after.savings);
}

INSTANTIATE_TEST_SUITE_P(Random, Trim, testing::Range<std::uint64_t>(0, 24));

Scene with_materials(std::vector<Material> materials) {
    Scene scene = soup(static_cast<std::uint32_t>(materials.size()), 0, 1);
    for (std::uint32_t i = 0; i < materials.size(); ++i) scene.mesh.material[i] = i;
    scene.materials = std::move(materials);
    return scene;
}

std::vector<std::string> names_after_trim(std::vector<Material> materials) {
    Scene scene = with_materials(std::move(materials));
    trim(scene);
    std::vector<std::string> names;
    for (const Material& m : scene.materials) names.push_back(m.name);
    return names;
}

using Names = std::vector<std::string>;

TEST(TrimMaterials, OfOneTypeThatBehaveAlikeAreOne) {
    MaterialDescription tinted = mirror(gray(0.5f));
    tinted.diffuse = {1, 0, 0};
    EXPECT_EQ(names_after_trim({{"a", mirror(gray(0.5f))}, {"b", tinted}}), Names{"a"});
    // Those that would reflect more than arrives are scaled down.
    EXPECT_EQ(
        names_after_trim({{"a", plastic(gray(0.5f), gray(0.5f), 9)}, {"b", plastic(gray(1), gray(1), 9)}}),
        Names{"a"});
}

TEST(TrimMaterials, ThatDifferInAnythingStayApart) {
    const MaterialDescription shine = plastic(gray(0.5f), gray(0.25f), 9);
    const std::vector<Material> materials = {{"type", emissive(gray(0.5f))},
                                             {"other type", mirror(gray(0.5f))},
                                             {"matte", matte(gray(0.5f))},
                                             {"colour", matte({0.5f, 0.5f, 0.51f})},
                                             {"texture", textured(matte(gray(0.5f)), 0)},
                                             {"other texture", textured(matte(gray(0.5f)), 2)},
                                             {"plastic", shine},
                                             {"exponent", plastic(gray(0.5f), gray(0.25f), 10)},
                                             {"gloss", plastic(gray(0.5f), gray(0.26f), 9)}};
    EXPECT_EQ(names_after_trim(materials).size(), materials.size());
}

TEST(TrimMaterials, SpheresMayShareATriangles) {
    Scene scene = with_materials({{"a", matte(gray(0.5f))}, {"b", mirror(gray(0.5f))}});
    scene.materials.push_back({"spheres", mirror(gray(0.5f))});
    scene.sphere_material = 2;
    scene.spheres.push_back({{0, 0, 0}, 1});
    trim(scene);
    EXPECT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.sphere_material, 1u);
}

TEST(TrimMaterials, OfNoSpheresIsNotKept) {
    Scene scene = with_materials({{"a", matte(gray(0.5f))}});
    scene.materials.push_back({"spheres", mirror(gray(0.5f))});
    scene.sphere_material = 1;
    trim(scene);
    EXPECT_EQ(scene.materials.size(), 1u);
    EXPECT_EQ(scene.sphere_material, 0u);
}

TEST(TrimMaterials, AreNeverNone) {
    Scene scene;
    scene.mesh.positions = {{0, 0, 0}, {1, 0, 0}};
    scene.materials = {{"a", matte(gray(0.5f))}, {"b", mirror(gray(0.5f))}};
    scene.sphere_material = 1;
    for (int i = 0; i < 2; ++i) {
        trim(scene);
        ASSERT_EQ(scene.materials.size(), 1u);
        EXPECT_EQ(scene.materials[0].name, "a");
        EXPECT_EQ(scene.sphere_material, 0u);
        EXPECT_TRUE(scene.mesh.positions.empty());
        EXPECT_EQ(scene.savings, (SceneSavings{2, 0, 1, 0}));
        EXPECT_EQ(needs_of(scene), SceneNeeds{});
    }
}

}  // namespace
}  // namespace ctpbench::test
