// Parts of the atrium. x runs along the nave, the court is open to the sky, aisles lie to either side.
#pragma once

#include "scene/recipes/random.h"
#include "scene/recipes/walls.h"

namespace ctpbench::recipe {

struct SponzaPalette {
    MaterialId stone, trim, wall, brick, floor_light, floor_dark, grout, vault, tile, wood, red, green, blue,
        bronze, lantern, plaque, leaf, clay;

    explicit SponzaPalette(std::vector<Material>& materials);
};

struct SponzaSize {
    static constexpr int bays = 9;
    static constexpr float bay = 3.7f;
    static constexpr float half_length = bays * bay / 2;
    static constexpr float court = 3.6f;         // |z| of the columns' axes
    static constexpr float outer = 7.6f;         // |z| of the outer walls
    static constexpr float spring = 4.0f;        // of the ground floor's arches
    static constexpr float gallery = 6.2f;       // floor of the upper storey
    static constexpr float upper_spring = 9.1f;  // of its arches
    static constexpr float eaves = 10.5f, ridge = 11.6f;
};

// One side of the nave in a frame whose origin is the middle of the court's edge on the floor, x along the
// nave and z towards the court; it covers -half_length .. half_length.
void sponza_ground_storey(Mesh& mesh, const Frame& side, const SponzaPalette& p);
void sponza_upper_storey(Mesh& mesh, const Frame& side, const SponzaPalette& p);
void sponza_roof(Mesh& mesh, const Frame& side, const SponzaPalette& p);

void sponza_floor(Mesh& mesh, const SponzaPalette& p, Random& random);
// An end of the nave; the frame's origin is on the floor in its middle, z towards the court.
void sponza_end_wall(Mesh& mesh, const Frame& end, const SponzaPalette& p);
// A lion's head on a round plate of that radius, facing the frame's z.
void lion_plaque(Mesh& mesh, const Frame& frame, float radius, const SponzaPalette& p);
// Hangs from the frame's origin.
void lantern(Mesh& mesh, const Frame& frame, float chain, const SponzaPalette& p);

}  // namespace ctpbench::recipe
