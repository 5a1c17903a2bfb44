// Parts of the hacienda's courtyard. The court is a rectangle around the origin; an arcade with a gallery
// above it closes the side towards -z, plain walls the other three.
#pragma once

#include <vector>

#include "scene/recipes/foliage.h"
#include "scene/recipes/walls.h"

namespace ctpbench::recipe {

struct CourtyardPalette {
    MaterialId ochre, rose, white, stone, trim, tile_red, tile_sand, grout, roof, wood, iron, cloth, napkin,
        china, glass, silver, straw, water, clay, bark, flower;
    MaterialId leaves[4];
    MaterialId ivy[3];

    explicit CourtyardPalette(std::vector<Material>& materials);
};

struct CourtyardSize {
    static constexpr float half_x = 12, half_z = 9;
    static constexpr float arcade = 3.5f;  // depth behind z = -half_z
    static constexpr float storey = 4.2f, wall = 8.4f;
    static constexpr int bays = 8;
    static constexpr float bay = 2 * half_x / bays;
};

void courtyard_floor(Mesh& mesh, const CourtyardPalette& p, Random& random);
void courtyard_arcade(Mesh& mesh, const CourtyardPalette& p);
void courtyard_gallery(Mesh& mesh, const CourtyardPalette& p);
// A wall of that width seen from the court: doors below, grilled windows and two balconies above. The frame's
// origin is its lower left corner, z towards the court.
void courtyard_wall(Mesh& mesh, const Frame& frame, float width, MaterialId plaster,
                    const CourtyardPalette& p);
// A balustrade along the frame's x from 0 to length.
void railing(Mesh& mesh, const Frame& frame, float length, const CourtyardPalette& p);
void fountain(Mesh& mesh, const CourtyardPalette& p);

void patio_chair(Mesh& mesh, const CourtyardPalette& p);                  // facing +z
void patio_table(Mesh& mesh, const CourtyardPalette& p, Random& random);  // laid for four

}  // namespace ctpbench::recipe
