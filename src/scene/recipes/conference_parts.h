// Furniture and fittings of the conference room. Each is built once in its own coordinates and placed as
// often as needed.
#pragma once

#include "scene/recipes/random.h"
#include "scene/recipes/walls.h"

namespace ctpbench::recipe {

struct ConferencePalette {
    MaterialId wall, carpet, ceiling, wood, dark_wood, upholstery, metal, black, white, paper, glass,
        daylight, fabric, lamp, blue, red, green, leaf, clay;

    explicit ConferencePalette(std::vector<Material>& materials);
};

constexpr float conference_half_length = 8.0f, conference_half_width = 4.8f, conference_height = 3.2f;

// On the floor at the origin, facing +z; about 4,500 triangles.
void swivel_chair(Mesh& mesh, const ConferencePalette& p);
// Boat-shaped, its length along x.
void conference_table(Mesh& mesh, const ConferencePalette& p, float length, float width, float height);
// On a table top at y = 0, its user at -z.
void place_setting(Mesh& mesh, const ConferencePalette& p, bool laptop, Random& random);
void telephone(Mesh& mesh, const ConferencePalette& p);
// Carafes, glasses and the cables in the middle of the table.
void table_middle(Mesh& mesh, const ConferencePalette& p, float table_height, Random& random);

void conference_ceiling(Mesh& mesh, const ConferencePalette& p);
void conference_walls(Mesh& mesh, const ConferencePalette& p);
void conference_windows(Mesh& mesh, const ConferencePalette& p, Random& random);
void whiteboard(Mesh& mesh, const Frame& frame, const ConferencePalette& p, Random& random);

// Where the four windows are on their wall: x from the room's corner, y from the floor.
std::span<const Opening> conference_window_openings();

}  // namespace ctpbench::recipe
