#include "scene/recipes/recipes.h"

#include <array>

#include "scene/recipes/builders.h"

namespace ctpbench {
namespace {

template <auto build>
void of_one_size(Mesh& mesh, std::vector<Material>& materials, std::uint64_t seed, std::size_t) {
    build(mesh, materials, seed);
}

template <auto build>
constexpr Recipe one_size(const char* name, std::size_t triangles) {
    return {name, triangles, triangles, of_one_size<build>};
}

}  // namespace

std::span<const Recipe> recipes() {
    using namespace recipe;
    static constexpr std::array<Recipe, 5> all{{
        one_size<build_conference_like>("conference_like", conference_like_triangles),
        one_size<build_sponza_like>("sponza_like", sponza_like_triangles),
        one_size<build_san_miguel_like>("san_miguel_like", san_miguel_like_triangles),
        one_size<build_smoke>("smoke", smoke_triangles),
        {"grove", 100'000, 10'000, build_grove},
    }};
    return all;
}

const Recipe* find_recipe(std::string_view name) {
    for (const Recipe& recipe : recipes()) {
        if (name == recipe.name) return &recipe;
    }
    return nullptr;
}

}  // namespace ctpbench
