#include "scene/recipes/recipes.h"

#include <array>

#include "scene/recipes/builders.h"

namespace ctpbench {

std::span<const Recipe> recipes() {
    using namespace recipe;
    static constexpr std::array<Recipe, 4> all{{
        {"conference_like", conference_like_triangles, build_conference_like},
        {"sponza_like", sponza_like_triangles, build_sponza_like},
        {"san_miguel_like", san_miguel_like_triangles, build_san_miguel_like},
        {"smoke", smoke_triangles, build_smoke},
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
