#include "scene/triangulate.h"

#include <cmath>

namespace ctpbench {
namespace {

struct Point {
    double x, y;
    bool operator==(const Point&) const = default;
};

// Twice the signed area of a triangle.
double area(Point a, Point b, Point c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

// The polygon projected along the largest component of its normal (Newell's), mirrored if need be so that it
// turns counterclockwise.
std::vector<Point> project(std::span<const Vec3> positions, std::span<const std::uint32_t> corners) {
    double normal[3] = {};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 p = positions[corners[i]], q = positions[corners[(i + 1) % corners.size()]];
        for (int axis = 0; axis < 3; ++axis) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            normal[axis] += (static_cast<double>(p[u]) - q[u]) * (static_cast<double>(p[v]) + q[v]);
        }
    }
    int axis = 0;
    for (int other = 1; other < 3; ++other) {
        if (std::fabs(normal[other]) > std::fabs(normal[axis])) axis = other;
    }
    const double mirror = normal[axis] < 0.0 ? -1.0 : 1.0;
    std::vector<Point> points;
    for (const std::uint32_t corner : corners) {
        const Vec3 p = positions[corner];
        points.push_back({mirror * p[(axis + 1) % 3], p[(axis + 2) % 3]});
    }
    return points;
}

// An ear is a convex corner whose triangle holds no other corner. `ring` lists the corners that are left. A
// corner that coincides with one of the ear's does not count: a slit to a hole visits its ends twice.
bool is_ear(const std::vector<Point>& points, const std::vector<std::uint32_t>& ring, std::size_t at) {
    const std::size_t before = (at + ring.size() - 1) % ring.size(), after = (at + 1) % ring.size();
    const Point a = points[ring[before]], b = points[ring[at]], c = points[ring[after]];
    if (!(area(a, b, c) > 0.0)) return false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point p = points[ring[i]];
        if (p == a || p == b || p == c) continue;
        if (area(a, b, p) >= 0.0 && area(b, c, p) >= 0.0 && area(c, a, p) >= 0.0) return false;
    }
    return true;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec3> positions,
                                                      std::span<const std::uint32_t> corners) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    const std::vector<Point> points = project(positions, corners);
    std::vector<std::uint32_t> ring(corners.size());
    for (std::uint32_t i = 0; i < ring.size(); ++i) ring[i] = i;

    // Corner 1 comes first: a convex polygon then becomes the fan around its first corner.
    bool ears_left = true;
    while (ring.size() >= 3) {
        std::size_t cut = 1;
        if (ears_left) {
            std::size_t tried = 0;
            while (tried < ring.size() && !is_ear(points, ring, (1 + tried) % ring.size())) ++tried;
            ears_left = tried < ring.size();
            if (ears_left) cut = (1 + tried) % ring.size();
        }
        const std::size_t before = (cut + ring.size() - 1) % ring.size(), after = (cut + 1) % ring.size();
        triangles.push_back({ring[before], ring[cut], ring[after]});
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(cut));
    }
    return triangles;
}

}  // namespace ctpbench
