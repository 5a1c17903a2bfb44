#include "scene/recipes/foliage.h"

#include <algorithm>
#include <array>

#include "scene/recipes/shapes.h"

namespace ctpbench::recipe {

void leaf(Mesh& mesh, const Frame& frame, float length, float width, int triangles, MaterialId material) {
    // Around the rim from the stalk; the sides stand up from the midrib and the tip hangs.
    constexpr Vec3 rim[] = {{0, 0, 0},         {0.4f, 0.3f, 0.10f},   {0.36f, 0.7f, 0.06f},
                            {0, 1.0f, -0.12f}, {-0.36f, 0.7f, 0.06f}, {-0.4f, 0.3f, 0.10f}};
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int i = 0; i < triangles + 2; ++i) {
        add_vertex(mesh, frame.point({rim[i].x * width, rim[i].y * length, rim[i].z * length}));
    }
    for (int i = 0; i < triangles; ++i) {
        const auto k = static_cast<std::uint32_t>(i);
        add_triangle(mesh, first, first + k + 1, first + k + 2, material);
    }
}

void scatter_leaves(Mesh& mesh, std::span<const Twig> twigs, std::size_t triangles, const LeafStyle& style,
                    Random& random) {
    const bool faces = dot(style.facing, style.facing) > 0;
    while (triangles > 0) {
        const Twig& twig = twigs[random.below(static_cast<std::uint32_t>(twigs.size()))];
        const float reach = style.spread * random.unit();
        Vec3 offset = random.direction() * reach;
        Vec3 normal = random.direction();
        Vec3 along = random.direction() + Vec3{0, -0.4f, 0};
        if (faces) {
            const float depth = dot(offset, style.facing);
            offset = offset + style.facing * (0.02f + 0.35f * absolute(depth) - depth);
            normal = normalize(normal * 0.6f + style.facing);
        }
        along = along - normal * dot(along, normal);
        if (dot(along, along) < 0.01f) continue;
        along = normalize(along);
        Vec3 origin = twig.from + (twig.to - twig.from) * random.unit() + offset;
        const float size = random.between(0.67f, 1.33f), lowest = 1.4f * style.length;
        if (origin.y < lowest) origin.y = min(2 * lowest - origin.y, 3 * lowest);  // the ground is at y = 0
        const int count = static_cast<int>(std::min<std::size_t>(triangles, 4));
        const auto hue = random.below(static_cast<std::uint32_t>(style.materials.size()));
        leaf(mesh, {cross(along, normal), along, normal, origin}, style.length * size, style.width * size,
             count, style.materials[hue]);
        triangles -= static_cast<std::size_t>(count);
    }
}

namespace {

struct Branch {
    Vec3 from, direction;
    float length, radius;
};

void grow_branch(Mesh& mesh, const Branch& branch, int depth, MaterialId bark, Random& random,
                 std::vector<Twig>& twigs) {
    std::array<Vec3, 5> path;
    Vec3 direction = branch.direction;
    path[0] = branch.from;
    for (std::size_t i = 1; i < path.size(); ++i) {
        direction = normalize(direction + random.direction() * 0.22f + Vec3{0, 0.05f, 0});
        path[i] = path[i - 1] + direction * (branch.length / 4);
    }
    tube(mesh, path, branch.radius, branch.radius * 0.6f, std::max(4, 3 + 2 * depth), bark);
    if (depth == 0) {
        for (std::size_t i = 1; i < path.size(); ++i) twigs.push_back({path[i - 1], path[i]});
        return;
    }
    const std::uint32_t children = 3 + random.below(2);
    const float start = random.unit();
    for (std::uint32_t i = 0; i < children; ++i) {
        const auto [c, s] = circle(start + (static_cast<float>(i) + random.between(-0.2f, 0.2f)) /
                                               static_cast<float>(children));
        const Frame fork = standing(path[i == 0 ? 4 : 2 + i % 3], direction);
        const float lean = random.between(0.6f, 1.1f);
        const Vec3 outward = normalize(fork.x * (lean * c) + fork.z * (lean * s) + fork.y);
        grow_branch(
            mesh, {fork.origin, outward, branch.length * random.between(0.62f, 0.8f), branch.radius * 0.55f},
            depth - 1, bark, random, twigs);
    }
}

}  // namespace

std::vector<Twig> grow_tree(Mesh& mesh, Vec3 root, const TreeShape& shape, MaterialId bark, Random& random) {
    std::vector<Twig> twigs;
    const Vec3 lean = normalize(Vec3{random.between(-0.12f, 0.12f), 1, random.between(-0.12f, 0.12f)});
    grow_branch(mesh, {root, lean, shape.height * 0.42f, shape.trunk_radius}, shape.depth, bark, random,
                twigs);
    return twigs;
}

std::vector<Twig> grow_vines(Mesh& mesh, const Frame& frame, float width, float height, int vines,
                             MaterialId bark, Random& random) {
    std::vector<Twig> twigs;
    constexpr float step = 0.22f;
    for (int vine = 0; vine < vines; ++vine) {
        float x = random.between(0.02f, 0.98f) * width, y = 0.01f, lean = random.between(-0.3f, 0.3f);
        const float reach = height * (0.35f + 0.65f * random.unit());
        std::vector<Vec3> path{frame.point({x, y, 0.03f})};
        while (y < reach) {
            lean = std::clamp(lean * 0.9f + random.between(-0.4f, 0.4f), -1.0f, 1.0f);
            x = std::clamp(x + lean * step, 0.05f, width - 0.05f);
            y += step * random.between(0.4f, 0.9f);
            path.push_back(frame.point({x, std::min(y, height), random.between(0.02f, 0.05f)}));
            twigs.push_back({path[path.size() - 2], path.back()});
        }
        tube(mesh, path, 0.018f, 0.006f, 5, bark);
    }
    return twigs;
}

std::vector<Twig> potted_stems(Mesh& mesh, const Frame& frame, float pot_radius, float height, int stems,
                               MaterialId clay, MaterialId bark, Random& random) {
    const float r = pot_radius;
    const ProfilePoint pot[] = {{0.6f * r, 0.003f},     {0.75f * r, 0.5f * r}, {0.92f * r, 1.3f * r},
                                {1.05f * r, 1.32f * r}, {1.08f * r, 1.5f * r}, {0.98f * r, 1.52f * r},
                                {0.92f * r, 1.36f * r}, {0, 1.36f * r}};
    lathe(mesh, frame, pot, 24, clay);
    std::vector<Twig> twigs;
    for (int i = 0; i < stems; ++i) {
        Vec3 direction = normalize(Vec3{random.between(-0.5f, 0.5f), 1, random.between(-0.5f, 0.5f)});
        std::vector<Vec3> path{frame.point({random.bell() * 0.4f * r, 1.33f * r, random.bell() * 0.4f * r})};
        for (int k = 0; k < 5; ++k) {
            direction = normalize(direction + random.direction() * 0.25f);
            path.push_back(path.back() + frame.vector(direction) * (height / 5));
            if (k > 0) twigs.push_back({path[path.size() - 2], path.back()});
        }
        tube(mesh, path, 0.03f * r, 0.012f * r, 5, bark);
    }
    return twigs;
}

}  // namespace ctpbench::recipe
