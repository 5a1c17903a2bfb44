// An OBJ file's triangles and the names it refers to, as parsed; what the cache keeps.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace ctpbench {

// A name that the OBJ file mentions, and the line (from 1) that mentions it first.
struct ObjName {
    std::string name;
    std::uint64_t line = 0;
};

// Triangles that no tree could hold: they would poison bounds or can never be hit.
struct DroppedTriangles {
    std::uint64_t bad_vertex = 0;  // a coordinate that is NaN, infinite or beyond 1e18
    std::uint64_t zero_area = 0;
    std::uint64_t first_line = 0;  // of the first face with one

    std::uint64_t total() const { return bad_vertex + zero_area; }
};

// Texture coordinates that are no finite numbers, or beyond 1e18: they count as (0, 0).
struct BadTexcoords {
    std::uint64_t count = 0;
    std::uint64_t first_line = 0;
};

struct ObjMesh {
    Mesh mesh;                       // mesh.material[i] is a position in `materials`
    std::vector<ObjName> materials;  // named by usemtl, in order; "" stands for faces before any usemtl
    std::vector<ObjName> libraries;  // named by mtllib, in order
    DroppedTriangles dropped;
    BadTexcoords bad_texcoords;
};

// Polygons are triangulated. A face may only use vertices and texture coordinates that are defined above it;
// a corner without texture coordinates has (0, 0), and a mesh without any has none. Throws Error(usage) for
// what cannot be understood; `file` is the name to show.
ObjMesh parse_obj(std::string_view text, const std::string& file);

}  // namespace ctpbench
