// Parts of buildings. Lengths are metres, y is up.
#pragma once

#include <span>

#include "scene/recipes/mesh_edit.h"

namespace ctpbench::recipe {

struct Opening {
    float x0, x1, y0, y1;
};

// A wall in the frame's x-y plane from the origin to (width, height), facing +z, with rectangular openings
// whose reveals reach `depth` behind it. Cells between the openings' edges share their vertices, so there are
// no T-junctions.
void pierced_wall(Mesh& mesh, const Frame& frame, float width, float height,
                  std::span<const Opening> openings, float depth, MaterialId material);

struct Arch {
    float width;      // of the bay, from axis to axis
    float radius;     // of the half circle, centred in the bay
    float spring;     // height where the arch begins
    float top;        // upper edge of the wall
    float thickness;  // along z, from 0 to -thickness
    int segments;     // of the half circle
};

// The wall above an arcade's columns: a bay with a half-round arch, front and back, underside included.
// Bays set side by side share their edges' positions.
void arch_bay(Mesh& mesh, const Frame& frame, const Arch& arch, MaterialId material);

// A raised moulding around the arch's front edge.
void archivolt(Mesh& mesh, const Frame& frame, const Arch& arch, float width, MaterialId material);

// The underside of two crossing barrel vaults over a rectangle centred at the frame's origin; `rise` is the
// height of both crowns. The groins run along cell diagonals. `n` is even.
void groin_vault(Mesh& mesh, const Frame& frame, float width, float depth, float rise, int n,
                 MaterialId material);

struct Column {
    float radius, height;
    int sides;
    int leaves;  // around the capital; 0 for a plain one
};

// Plinth, base mouldings, a shaft with entasis, a capital with curling leaves, abacus.
void column(Mesh& mesh, const Frame& frame, const Column& shape, MaterialId shaft, MaterialId trim);

}  // namespace ctpbench::recipe
