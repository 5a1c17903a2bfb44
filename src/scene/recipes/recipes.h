// Stand-in scenes: procedural rooms with the paper's triangle counts and a like mix of triangle sizes and
// depth complexity, for machines that do not have the scanned or modelled originals. They are stand-ins:
// figures measured on them compare with one another, never with the paper's absolute figures.
//
// A recipe is a function of its seed alone. All randomness is Philox, all angles go through additions and
// multiplications, so a seed gives the same mesh bit for bit on every IEEE machine (contraction off).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace ctpbench {

struct Recipe {
    const char* name;
    std::size_t triangles;  // exactly
    // Fills an empty mesh and an empty list of materials. Units are metres, y is up.
    void (*build)(Mesh& mesh, std::vector<Material>& materials, std::uint64_t seed);
};

std::span<const Recipe> recipes();

// Null if there is none of that name.
const Recipe* find_recipe(std::string_view name);

}  // namespace ctpbench
