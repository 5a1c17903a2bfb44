// The build function of every recipe, each in the file of its name, and the exact triangle count of those
// that come in one size.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace ctpbench::recipe {

constexpr std::size_t conference_like_triangles = 331'000;
constexpr std::size_t sponza_like_triangles = 262'000;
constexpr std::size_t san_miguel_like_triangles = 7'842'000;
constexpr std::size_t smoke_triangles = 10'000;

void build_conference_like(Mesh& mesh, std::vector<Material>& materials, std::uint64_t seed);
void build_sponza_like(Mesh& mesh, std::vector<Material>& materials, std::uint64_t seed);
void build_san_miguel_like(Mesh& mesh, std::vector<Material>& materials, std::uint64_t seed);
void build_smoke(Mesh& mesh, std::vector<Material>& materials, std::uint64_t seed);
void build_grove(Mesh& mesh, std::vector<Material>& materials, std::uint64_t seed, std::size_t triangles);

}  // namespace ctpbench::recipe
