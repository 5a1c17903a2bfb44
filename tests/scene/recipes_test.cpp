// What a stand-in promises: exact counts, sound geometry, and the same mesh for the same seed.
#include "scene/recipes/recipes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>
#include <string>

#include "kernels/materials/list.h"

namespace ctpbench {

void PrintTo(const Recipe& recipe, std::ostream* out) { *out << recipe.name; }

namespace {

struct Built {
    Mesh mesh;
    std::vector<Material> materials;
};

Built build(const Recipe& recipe, std::uint64_t seed) {
    Built built;
    recipe.build(built.mesh, built.materials, seed, recipe.triangles);
    return built;
}

bool same(const Mesh& a, const Mesh& b) {
    return a.positions == b.positions && a.triangles == b.triangles && a.material == b.material;
}

struct Extent {
    Vec3 low, high;
};

Extent extent(const Mesh& mesh) {
    Extent e{mesh.positions.front(), mesh.positions.front()};
    for (const Vec3& p : mesh.positions) e = {min(e.low, p), max(e.high, p)};
    return e;
}

class Recipes : public ::testing::TestWithParam<Recipe> {};

TEST_P(Recipes, GeometryIsSound) {
    const Recipe& recipe = GetParam();
    const auto [mesh, materials] = build(recipe, 1);
    ASSERT_EQ(mesh.triangles.size(), recipe.triangles);
    ASSERT_EQ(mesh.material.size(), recipe.triangles);
    const auto finite = [](const Vec3& p) {
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    };
    EXPECT_TRUE(std::all_of(mesh.positions.begin(), mesh.positions.end(), finite));

    std::vector<bool> vertex_used(mesh.positions.size()), material_used(materials.size());
    std::size_t bad_index = 0, bad_material = 0, no_area = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& t = mesh.triangles[i];
        if (*std::max_element(t.begin(), t.end()) >= mesh.positions.size()) {
            ++bad_index;
            continue;
        }
        for (const std::uint32_t v : t) vertex_used[v] = true;
        if (mesh.material[i] < materials.size()) {
            material_used[mesh.material[i]] = true;
        } else {
            ++bad_material;
        }
        const TriangleShape shape = mesh.triangle(i);
        // A hundredth of a square millimetre is ten times below the finest detail of any recipe.
        if (!(length(cross(shape.b - shape.a, shape.c - shape.a)) / 2 > 1e-8f)) ++no_area;
    }
    EXPECT_EQ(bad_index, 0u);
    EXPECT_EQ(bad_material, 0u);
    EXPECT_EQ(no_area, 0u);
    EXPECT_EQ(std::count(vertex_used.begin(), vertex_used.end(), false), 0);
    EXPECT_EQ(std::count(material_used.begin(), material_used.end(), false), 0);
}

TEST_P(Recipes, NoTriangleOccursTwice) {
    const auto [mesh, materials] = build(GetParam(), 1);
    using Key = std::array<std::array<float, 3>, 3>;
    std::vector<Key> keys;
    keys.reserve(mesh.triangles.size());
    for (const auto& t : mesh.triangles) {
        Key key;
        for (int k = 0; k < 3; ++k)
            key[k] = {mesh.positions[t[k]].x, mesh.positions[t[k]].y, mesh.positions[t[k]].z};
        std::sort(key.begin(), key.end());
        keys.push_back(key);
    }
    std::sort(keys.begin(), keys.end());
    EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end());
}

TEST_P(Recipes, SeedDecidesTheMesh) {
    const Recipe& recipe = GetParam();
    const Built first = build(recipe, 1);
    EXPECT_TRUE(same(first.mesh, build(recipe, 1).mesh));
    const Built other = build(recipe, 2);
    EXPECT_FALSE(same(first.mesh, other.mesh));
    EXPECT_EQ(other.mesh.triangles.size(), recipe.triangles);
}

TEST_P(Recipes, MaterialsAreNamedAndDescribed) {
    const auto [mesh, materials] = build(GetParam(), 1);
    std::set<std::string> names;
    for (const Material& m : materials) {
        EXPECT_FALSE(m.name.empty());
        EXPECT_TRUE(names.insert(m.name).second) << m.name << " occurs twice";
        const MaterialDescription& look = m.look;
        EXPECT_FALSE(look.texture.exists()) << m.name;
        for (int c = 0; c < 3; ++c) {
            EXPECT_GT(look.diffuse[c], 0.0f) << m.name;
            EXPECT_LT(look.diffuse[c], 1.0f) << m.name;
            if (look.type == material_type<Plastic>) {  // together they must not reflect more than arrives
                EXPECT_GT(look.specular[c], 0.0f) << m.name;
                EXPECT_LE(look.specular[c] + look.diffuse[c], 1.0f) << m.name;
                EXPECT_GT(look.exponent, 0.0f) << m.name;
            }
            if (look.type == material_type<Mirror>) {
                EXPECT_GT(look.specular[c], 0.0f) << m.name;
                EXPECT_LT(look.specular[c], 1.0f) << m.name;
            }
            if (look.type == material_type<Emissive>) {
                EXPECT_GT(look.emission[c], 0.0f) << m.name;
            }
        }
    }
}

// The courtyard is lit by the sky alone.
TEST_P(Recipes, HasThePapersMaterialTypes) {
    const auto [mesh, materials] = build(GetParam(), 1);
    std::set<std::uint32_t> types;
    for (const std::uint32_t id : mesh.material) types.insert(materials[id].look.type);
    std::set<std::uint32_t> expected = {material_type<Matte>, material_type<Plastic>, material_type<Mirror>,
                                        material_type<Emissive>};
    if (GetParam().name == std::string("san_miguel_like")) expected.erase(material_type<Emissive>);
    EXPECT_EQ(types, expected);
}

// Rooms have a few huge triangles beside very many tiny ones; that mix is what makes them hard.
TEST_P(Recipes, TriangleSizesSpanManyDecades) {
    const auto [mesh, materials] = build(GetParam(), 1);
    std::vector<float> areas;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const TriangleShape t = mesh.triangle(i);
        areas.push_back(length(cross(t.b - t.a, t.c - t.a)) / 2);
    }
    std::sort(areas.begin(), areas.end());
    EXPECT_LT(areas[areas.size() / 2], 0.01f);
    EXPECT_GT(areas.back(), 5.0f);
}

TEST_P(Recipes, SceneFileNamesTheRecipeAndStandsInside) {
    const Recipe& recipe = GetParam();
    const auto [mesh, materials] = build(recipe, 1);
    std::ifstream file(std::string(CTPBENCH_SOURCE_DIR) + "/scenes/" + recipe.name + ".json");
    ASSERT_TRUE(file.is_open());
    const auto scene = nlohmann::json::parse(file);
    EXPECT_EQ(scene.at("name"), recipe.name);
    EXPECT_EQ(scene.at("recipe").at("name"), recipe.name);
    const auto& eye_json = scene.at("camera").at("eye");
    const Vec3 eye{eye_json[0], eye_json[1], eye_json[2]};
    const Extent e = extent(mesh);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GT(eye[axis], e.low[axis]);
        EXPECT_LT(eye[axis], e.high[axis]);
    }
    float nearest = 1e9f;
    for (const Vec3& p : mesh.positions) nearest = std::min(nearest, length(p - eye));
    EXPECT_GT(nearest, 0.3f) << "something is in the camera's face";
}

TEST_P(Recipes, BoundsHugTheRoom) {
    const auto [mesh, materials] = build(GetParam(), 1);
    const Extent e = extent(mesh);
    const Vec3 size = e.high - e.low;
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GT(size[axis], 2.0f);
        EXPECT_LT(size[axis], 40.0f);
    }
    EXPECT_NEAR(e.low.y, 0.0f, 0.1f);  // the floor
}

INSTANTIATE_TEST_SUITE_P(All, Recipes, ::testing::ValuesIn(recipes().begin(), recipes().end()),
                         [](const auto& info) { return std::string(info.param.name); });

// What lets the cost of a ray be set against the number of triangles: nothing else changes.
TEST(Grove, HasTheSameSurfacesAtEverySize) {
    const Recipe& recipe = *find_recipe("grove");
    const auto of_size = [&](std::size_t triangles) {
        Mesh mesh;
        std::vector<Material> materials;
        recipe.build(mesh, materials, 1, triangles);
        EXPECT_EQ(mesh.triangles.size(), triangles);
        std::vector<double> areas(materials.size());
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const TriangleShape t = mesh.triangle(i);
            areas[mesh.material[i]] += length(cross(t.b - t.a, t.c - t.a)) / 2;
        }
        return areas;
    };
    const auto small = of_size(recipe.least), large = of_size(1'000'003);
    ASSERT_EQ(small.size(), large.size());
    for (std::size_t m = 0; m < small.size(); ++m) EXPECT_NEAR(small[m] / large[m], 1.0, 0.1) << m;
}

TEST(RecipeList, FindsByName) {
    ASSERT_NE(find_recipe("smoke"), nullptr);
    EXPECT_STREQ(find_recipe("smoke")->name, "smoke");
    EXPECT_EQ(find_recipe("smok"), nullptr);
}

TEST(RecipeList, HasThePapersCounts) {
    EXPECT_EQ(find_recipe("conference_like")->triangles, 331'000u);
    EXPECT_EQ(find_recipe("sponza_like")->triangles, 262'000u);
    EXPECT_EQ(find_recipe("san_miguel_like")->triangles, 7'842'000u);
}

}  // namespace
}  // namespace ctpbench
