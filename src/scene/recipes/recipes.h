// Stand-in scenes: procedural rooms with the paper's triangle counts and a like mix of triangle sizes and
// depth complexity, for machines that do not have the scanned or modelled originals. They are stand-ins:
// figures measured on them compare with one another, never with the paper's absolute figures.
//
// A recipe is a function of its seed and its size alone. All randomness is Philox, all angles go through
// additions and multiplications, so a seed gives the same mesh bit for bit on every IEEE machine (contraction
// off).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace ctpbench {

// More than a scene of any recipe may have: a tree's words reach as far as 4 GiB
// (kernels/interleaved/node.h).
inline constexpr std::size_t kMostTriangles = 20'000'000;

struct Recipe {
    const char* name;
    std::size_t triangles;  // exactly, unless another number is asked for
    std::size_t least;      // that it can be asked for; as many as `triangles`: it comes in one size
    // Fills an empty mesh, with exactly that many triangles, and an empty list of materials. Units are
    // metres, y is up.
    void (*build)(Mesh& mesh, std::vector<Material>& materials, std::uint64_t seed, std::size_t triangles);
};

std::span<const Recipe> recipes();

// Null if there is none of that name.
const Recipe* find_recipe(std::string_view name);

}  // namespace ctpbench
