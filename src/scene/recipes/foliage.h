// Plants: many small triangles in no order, the hard part of an outdoor scene for a tree of boxes.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "scene/recipes/mesh_edit.h"
#include "scene/recipes/random.h"

namespace ctpbench::recipe {

// A piece of twig that bears leaves.
struct Twig {
    Vec3 from, to;
};

struct LeafStyle {
    float length, width;  // of a leaf, varied by a third
    float spread;         // how far from its twig a leaf may sit
    Vec3 facing;          // leaves turn this way and stay on this side of the twig; zero for all ways
    std::span<const MaterialId> materials;
};

// A folded leaf along the frame's y axis, its face towards z; a fan of 1 to 4 triangles.
void leaf(Mesh& mesh, const Frame& frame, float length, float width, int triangles, MaterialId material);

// Leaves of four triangles (the last may have fewer) around random twigs: exactly `triangles` in all.
void scatter_leaves(Mesh& mesh, std::span<const Twig> twigs, std::size_t triangles, const LeafStyle& style,
                    Random& random);

struct TreeShape {
    float height, trunk_radius;
    int depth;  // of branching
};

// Grows trunk and branches, and returns the outermost twigs.
std::vector<Twig> grow_tree(Mesh& mesh, Vec3 root, const TreeShape& shape, MaterialId bark, Random& random);

// Vines that climb the frame's x-y plane from y = 0, within (width, height).
std::vector<Twig> grow_vines(Mesh& mesh, const Frame& frame, float width, float height, int vines,
                             MaterialId bark, Random& random);

// A pot of that radius with earth and stems; returns the stems.
std::vector<Twig> potted_stems(Mesh& mesh, const Frame& frame, float pot_radius, float height, int stems,
                               MaterialId clay, MaterialId bark, Random& random);

}  // namespace ctpbench::recipe
