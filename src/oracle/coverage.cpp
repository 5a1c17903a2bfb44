#include "oracle/coverage.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <vector>

namespace ctpbench {
namespace {

// Across the ray and along it, from its origin; in scene units.
struct Seen {
    double x, y, depth;
};
struct SeenTriangle {
    Seen corner[3];
};

class View {
public:
    explicit View(const ExactRay& ray) : o_(ray.origin) {
        const auto& d = ray.direction;
        const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        for (int i = 0; i < 3; ++i) along_[i] = d[i] / length;
        int smallest = 0;
        for (int i = 1; i < 3; ++i)
            if (std::fabs(along_[i]) < std::fabs(along_[smallest])) smallest = i;
        double axis[3] = {0, 0, 0};
        axis[smallest] = 1.0;
        cross(along_, axis, x_);
        const double norm = std::sqrt(x_[0] * x_[0] + x_[1] * x_[1] + x_[2] * x_[2]);
        for (double& c : x_) c /= norm;
        cross(along_, x_, y_);
    }
    SeenTriangle of(const TriangleShape& t) const { return {{of(t.a), of(t.b), of(t.c)}}; }

private:
    static void cross(const double* a, const double* b, double* out) {
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            out[i] = a[j] * b[k] - a[k] * b[j];
        }
    }
    Seen of(Vec3 p) const {
        const double f[3] = {p.x - o_[0], p.y - o_[1], p.z - o_[2]};
        const auto dot = [&](const double* e) { return f[0] * e[0] + f[1] * e[1] + f[2] * e[2]; };
        return {dot(x_), dot(y_), dot(along_)};
    }

    std::array<double, 3> o_;
    double along_[3], x_[3], y_[3];
};

// Of the axis from the segment.
double distance(const Seen& a, const Seen& b) {
    const double ex = b.x - a.x, ey = b.y - a.y, ee = ex * ex + ey * ey;
    const double s = ee > 0.0 ? std::clamp(-(a.x * ex + a.y * ey) / ee, 0.0, 1.0) : 0.0;
    return std::hypot(a.x + s * ex, a.y + s * ey);
}

// Swapping a and b negates it exactly, so two triangles never both lose a point on their common edge.
double side(const Seen& a, const Seen& b, double x, double y) {
    return (a.x - x) * (b.y - y) - (a.y - y) * (b.x - x);
}

// Whether the triangle is there, and in front of the origin by more than `radius`.
bool covers(const SeenTriangle& t, double x, double y, double radius) {
    const Seen &a = t.corner[0], &b = t.corner[1], &c = t.corner[2];
    const double u = side(b, c, x, y), v = side(c, a, x, y), w = side(a, b, x, y);
    if (!((u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0))) return false;
    const double sum = u + v + w;
    return sum != 0.0 && (u * a.depth + v * b.depth + w * c.depth) / sum > radius;
}

// The triangles that can be reached from `id` over vertices and edges within `radius` of the ray.
std::vector<SeenTriangle> joined_triangles(const GeometryView& geometry, const MeshAdjacency& adjacency,
                                           std::uint32_t id, double radius, const View& view) {
    std::vector<std::uint32_t> queue{id};
    std::unordered_set<std::uint32_t> known{id};
    std::vector<SeenTriangle> found;
    const auto reach = [&](std::uint32_t triangle) {
        if (known.insert(triangle).second) queue.push_back(triangle);
    };
    for (std::size_t next = 0; next < queue.size(); ++next) {
        const std::uint32_t at = queue[next];
        const SeenTriangle& seen = found.emplace_back(view.of(geometry.triangle(at)));
        for (int k = 0; k < 3; ++k) {
            const Seen &a = seen.corner[k], &b = seen.corner[(k + 1) % 3];
            if (!(distance(a, b) <= radius)) continue;
            const auto around_a = adjacency.around(adjacency.vertex(at, k));
            const auto around_b = adjacency.around(adjacency.vertex(at, (k + 1) % 3));
            if (std::hypot(a.x, a.y) <= radius) {
                for (const std::uint32_t triangle : around_a) reach(triangle);
            }
            for (const std::uint32_t triangle : around_a)
                if (std::binary_search(around_b.begin(), around_b.end(), triangle)) reach(triangle);
        }
    }
    return found;
}

constexpr double kTurn = 2.0 * 3.14159265358979323846;

// The directions, ascending, in which edges cross the circle about the ray.
std::vector<double> crossings(const std::vector<SeenTriangle>& triangles, double radius) {
    std::vector<double> angles;
    for (const SeenTriangle& t : triangles)
        for (int k = 0; k < 3; ++k) {
            // |a + s e|^2 = radius^2
            const Seen &a = t.corner[k], &b = t.corner[(k + 1) % 3];
            const double ex = b.x - a.x, ey = b.y - a.y, ee = ex * ex + ey * ey;
            const double middle = ee > 0.0 ? -(a.x * ex + a.y * ey) / ee : 0.0;
            const double mx = a.x + middle * ex, my = a.y + middle * ey;
            const double rest = radius * radius - mx * mx - my * my;
            if (!(ee > 0.0 && rest > 0.0)) continue;
            const double half = std::sqrt(rest / ee);
            for (const double s : {middle - half, middle + half})
                if (s >= 0.0 && s <= 1.0) angles.push_back(std::atan2(a.y + s * ey, a.x + s * ex));
        }
    std::sort(angles.begin(), angles.end());
    return angles;
}

}  // namespace

bool surface_covers(const GeometryView& geometry, const MeshAdjacency& adjacency, std::uint32_t id,
                    double radius, const ExactRay& ray) {
    const std::vector<SeenTriangle> joined = joined_triangles(geometry, adjacency, id, radius, View(ray));
    const auto covered = [&](double x, double y) {
        return std::any_of(joined.begin(), joined.end(),
                           [&](const SeenTriangle& t) { return covers(t, x, y, radius); });
    };
    // What covers the circle changes only where an edge crosses it, so a point between each two crossings
    // tells all: a gap seen nearly edge-on may be as narrow as it likes.
    const std::vector<double> angles = crossings(joined, radius);
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const double next = i + 1 < angles.size() ? angles[i + 1] : angles[0] + kTurn;
        const double between = 0.5 * (angles[i] + next);
        if (!covered(radius * std::cos(between), radius * std::sin(between))) return false;
    }
    if (angles.empty() && !covered(radius, 0.0)) return false;
    return covered(0.0, 0.0);
}

}  // namespace ctpbench
