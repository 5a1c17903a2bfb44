// The atrium: two storeys of arcades around a court open to the sky, stone of middling triangles, cloth and
// foliage of small ones.
#include "scene/recipes/builders.h"
#include "scene/recipes/cloth.h"
#include "scene/recipes/foliage.h"
#include "scene/recipes/shapes.h"
#include "scene/recipes/sponza_parts.h"

namespace ctpbench::recipe {

SponzaPalette::SponzaPalette(std::vector<Material>& materials)
    : stone(add_matte(materials, "stone", {0.68f, 0.62f, 0.52f})),
      trim(add_matte(materials, "trim", {0.75f, 0.70f, 0.61f})),
      wall(add_matte(materials, "plaster", {0.72f, 0.63f, 0.48f})),
      brick(add_matte(materials, "brick", {0.62f, 0.48f, 0.36f})),
      floor_light(add_plastic(materials, "floor_light", {0.60f, 0.56f, 0.50f}, 0.08f, 90)),
      floor_dark(add_plastic(materials, "floor_dark", {0.40f, 0.33f, 0.29f}, 0.08f, 90)),
      grout(add_matte(materials, "grout", {0.30f, 0.28f, 0.26f})),
      vault(add_matte(materials, "vault", {0.74f, 0.68f, 0.56f})),
      tile(add_matte(materials, "roof_tile", {0.62f, 0.30f, 0.18f})),
      wood(add_plastic(materials, "wood", {0.32f, 0.20f, 0.11f}, 0.04f, 30)),
      red(add_matte(materials, "red_cloth", {0.55f, 0.06f, 0.05f})),
      green(add_matte(materials, "green_cloth", {0.08f, 0.34f, 0.12f})),
      blue(add_matte(materials, "blue_cloth", {0.07f, 0.13f, 0.45f})),
      bronze(add_mirror(materials, "bronze", {0.62f, 0.48f, 0.26f})),
      lantern(add_emissive(materials, "lantern", {2.4f, 1.4f, 0.6f})),
      plaque(add_matte(materials, "plaque", {0.58f, 0.54f, 0.46f})),
      leaf(add_matte(materials, "leaf", {0.17f, 0.36f, 0.10f})),
      clay(add_plastic(materials, "clay", {0.62f, 0.36f, 0.22f}, 0.05f, 40)) {}

namespace {

using Size = SponzaSize;

void vases(Mesh& mesh, const Frame& side, const SponzaPalette& p, Random& random) {
    const MaterialId greens[] = {p.leaf};
    for (int i = 1; i < Size::bays; i += 2) {
        const float x = -Size::half_length + Size::bay * static_cast<float>(i);
        const auto stems =
            potted_stems(mesh, side * at({x, 0.001f, 0.95f}), 0.32f, 0.8f, 10, p.clay, p.leaf, random);
        scatter_leaves(mesh, stems, 2400, {0.16f, 0.06f, 0.12f, {0, 0, 0}, greens}, random);
    }
}

}  // namespace

void build_sponza_like(Mesh& mesh, std::vector<Material>& materials, std::uint64_t seed) {
    reserve(mesh, sponza_like_triangles, sponza_like_triangles);
    const SponzaPalette p(materials);
    Random random(seed, 0);
    // z towards the court on either side.
    const Frame sides[] = {at({0, 0, -Size::court}), at({0, 0, Size::court}, 0.5f)};
    sponza_floor(mesh, p, random);
    for (const Frame& side : sides) {
        sponza_ground_storey(mesh, side, p);
        sponza_upper_storey(mesh, side, p);
        sponza_roof(mesh, side, p);
        vases(mesh, side, p, random);
        for (int i = 0; i < Size::bays; i += 2) {
            const float x = -Size::half_length + Size::bay * (static_cast<float>(i) + 0.5f);
            lantern(mesh, side * at({x, Size::spring + 1.74f, -2.0f}), 1.6f, p);
        }
    }
    sponza_end_wall(mesh, at({Size::half_length, 0, 0}, 0.75f), p);
    sponza_end_wall(mesh, at({-Size::half_length, 0, 0}, 0.25f), p);

    for (const Frame& side : sides) {  // curtain rods and the bars that carry the cloths before the parapet
        const Vec3 rod[] = {side.point({-Size::half_length + 0.02f, Size::spring + 0.13f, -0.65f}),
                            side.point({Size::half_length - 0.02f, Size::spring + 0.13f, -0.65f})};
        tube(mesh, rod, 0.03f, 0.03f, 10, p.bronze);
        const Vec3 bar[] = {side.point({-Size::half_length + 0.02f, Size::gallery + 0.88f, 0.95f}),
                            side.point({Size::half_length - 0.02f, Size::gallery + 0.88f, 0.95f})};
        tube(mesh, bar, 0.025f, 0.025f, 10, p.bronze);
    }
    // Curtains in the arches and cloths over the parapet, from the triangles that are left.
    const MaterialId colours[] = {p.red, p.green, p.red, p.blue};
    constexpr std::size_t cloths = 18;
    const std::size_t left = remaining(mesh, sponza_like_triangles, cloths * 1000);
    for (std::size_t i = 0; i < cloths; ++i) {
        const Frame& side = sides[i % 2];
        const std::size_t bay = i / 2;
        const bool curtain = bay % 2 == 0;
        const float x = -Size::half_length + Size::bay * static_cast<float>(bay) + (curtain ? 0.5f : 0.95f);
        const Cloth cloth = curtain ? Cloth{Size::bay - 1.0f, 3.3f, 0.22f, 8, 0.45f, 0.35f}
                                    : Cloth{Size::bay - 1.9f, 2.6f, 0.07f, 5, 0, 0.5f};
        const Vec3 top =
            curtain ? Vec3{x, Size::spring + 0.1f, -0.65f} : Vec3{x, Size::gallery + 0.85f, 0.95f};
        hang_cloth(mesh, side * at(top), cloth, share(left, i, cloths), colours[bay % 4], random);
    }
}

}  // namespace ctpbench::recipe
