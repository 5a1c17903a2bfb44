#include "scene/recipes/shapes.h"

#include <cmath>

#include "scene/recipes/surface.h"

namespace ctpbench::recipe {

void box(Mesh& mesh, const Frame& frame, Vec3 low, Vec3 high, MaterialId material) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int corner = 0; corner < 8; ++corner) {
        add_vertex(mesh, frame.point({corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y,
                                      corner & 4 ? high.z : low.z}));
    }
    constexpr std::uint32_t faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                           {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& f : faces) {
        add_quad(mesh, first + f[0], first + f[1], first + f[2], first + f[3], material);
    }
}

void cushion(Mesh& mesh, const Frame& frame, Vec3 half_size, int n, MaterialId material) {
    // Half way from the cube to the sphere. Neighbouring faces evaluate the same expression on their common
    // edge, so the seams close exactly.
    const auto rounded = [&](Vec3 p) {
        const float xx = p.x * p.x, yy = p.y * p.y, zz = p.z * p.z;
        const Vec3 sphere = {p.x * std::sqrt(1 - yy / 2 - zz / 2 + yy * zz / 3),
                             p.y * std::sqrt(1 - zz / 2 - xx / 2 + zz * xx / 3),
                             p.z * std::sqrt(1 - xx / 2 - yy / 2 + xx * yy / 3)};
        const Vec3 r = p * 0.55f + sphere * 0.45f;
        return frame.point({r.x * half_size.x, r.y * half_size.y, r.z * half_size.z});
    };
    for (int axis = 0; axis < 3; ++axis) {
        for (const float side : {-1.0f, 1.0f}) {
            surface(mesh, n, n, material, [&](float u, float v) {
                Vec3 p;
                p[axis] = side;
                p[(axis + 1) % 3] = side * (2 * u - 1);
                p[(axis + 2) % 3] = 2 * v - 1;
                return rounded(p);
            });
        }
    }
}

void lathe(Mesh& mesh, const Frame& frame, std::span<const ProfilePoint> profile, int sides,
           MaterialId material) {
    struct Ring {
        std::uint32_t first;
        bool pole;
    };
    const auto ring = [&](ProfilePoint p) {
        if (p.radius == 0.0f) return Ring{add_vertex(mesh, frame.point({0, p.height, 0})), true};
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (int i = 0; i < sides; ++i) {
            const auto [c, s] = circle(static_cast<double>(i) / sides);
            add_vertex(mesh, frame.point({p.radius * c, p.height, -p.radius * s}));
        }
        return Ring{first, false};
    };
    Ring below = ring(profile.front());
    for (const ProfilePoint& p : profile.subspan(1)) {
        const Ring above = ring(p);
        for (int i = 0; i < sides; ++i) {
            const int j = (i + 1) % sides;
            const auto a = below.first + i, b = below.first + j, c = above.first + j, d = above.first + i;
            if (below.pole) {
                add_triangle(mesh, below.first, c, d, material);
            } else if (above.pole) {
                add_triangle(mesh, a, b, above.first, material);
            } else {
                add_quad(mesh, a, b, c, d, material);
            }
        }
        below = above;
    }
}

void tube(Mesh& mesh, std::span<const Vec3> path, float first_radius, float last_radius, int sides,
          MaterialId material) {
    const std::size_t n = path.size();
    const auto tangent = [&](std::size_t i) {
        return normalize(path[i + 1 < n ? i + 1 : i] - path[i > 0 ? i - 1 : i]);
    };
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    Vec3 normal = standing({}, tangent(0)).x;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 t = tangent(i);
        normal = normalize(normal - t * dot(normal, t));
        const Vec3 binormal = cross(t, normal);
        const float along = static_cast<float>(i) / static_cast<float>(n - 1);
        const float radius = first_radius + (last_radius - first_radius) * along;
        for (int k = 0; k < sides; ++k) {
            const auto [c, s] = circle(static_cast<double>(k) / sides);
            add_vertex(mesh, path[i] + normal * (radius * c) + binormal * (radius * s));
        }
    }
    const auto stride = static_cast<std::uint32_t>(sides);
    const auto last = first + static_cast<std::uint32_t>(n - 1) * stride;
    const auto start = add_vertex(mesh, path.front()), end = add_vertex(mesh, path.back());
    for (std::uint32_t k = 0; k < stride; ++k) {
        const std::uint32_t next = (k + 1) % stride;
        for (auto row = first; row < last; row += stride) {
            add_quad(mesh, row + k, row + next, row + stride + next, row + stride + k, material);
        }
        add_triangle(mesh, start, first + next, first + k, material);
        add_triangle(mesh, end, last + k, last + next, material);
    }
}

void torus(Mesh& mesh, const Frame& frame, float radius, float thickness, int segments, int sides,
           MaterialId material) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto index = [&](int i, int k) {
        return first + static_cast<std::uint32_t>((i % segments) * sides + k % sides);
    };
    for (int i = 0; i < segments; ++i) {
        const auto [c, s] = circle(static_cast<double>(i) / segments);
        for (int k = 0; k < sides; ++k) {
            const auto [tc, ts] = circle(static_cast<double>(k) / sides);
            const float r = radius + thickness * tc;
            add_vertex(mesh, frame.point({r * c, thickness * ts, -r * s}));
        }
    }
    for (int i = 0; i < segments; ++i) {
        for (int k = 0; k < sides; ++k) {
            add_quad(mesh, index(i, k), index(i + 1, k), index(i + 1, k + 1), index(i, k + 1), material);
        }
    }
}

void prism(Mesh& mesh, const Frame& frame, std::span<const OutlinePoint> outline, float depth,
           MaterialId material) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto n = static_cast<std::uint32_t>(outline.size());
    for (const float z : {0.0f, depth}) {
        for (const OutlinePoint& p : outline) add_vertex(mesh, frame.point({p.x, p.y, z}));
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t j = (i + 1) % n;
        add_quad(mesh, first + i, first + j, first + n + j, first + n + i, material);
    }
    for (std::uint32_t i = 1; i + 1 < n; ++i) {
        add_triangle(mesh, first, first + i + 1, first + i, material);
        add_triangle(mesh, first + n, first + n + i, first + n + i + 1, material);
    }
}

}  // namespace ctpbench::recipe
