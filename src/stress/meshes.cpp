#include "stress/meshes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "scene/content_hash.h"
#include "scene/recipes/random.h"

namespace ctpbench {
namespace {

struct Point {
    double x, y, z;
};

Point unit(Point p) {
    const double l = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    return {p.x / l, p.y / l, p.z / l};
}

Vec3 rounded(Point p) { return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)}; }

// A fixed rotation, by angles that are no fraction of a turn.
Point turned(Point p) {
    const double c1 = std::cos(0.7), s1 = std::sin(0.7), c2 = std::cos(1.1), s2 = std::sin(1.1);
    const Point q{c1 * p.x - s1 * p.y, s1 * p.x + c1 * p.y, p.z};
    return {q.x, c2 * q.y - s2 * q.z, s2 * q.y + c2 * q.z};
}

using Faces = std::vector<std::array<std::uint32_t, 3>>;

// Four triangles of each; vertices stay on the unit sphere.
void subdivide(std::vector<Point>& points, Faces& faces) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [at, added] =
            middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<std::uint32_t>(points.size()));
        if (added) {
            const Point p = points[a], q = points[b];
            points.push_back(unit({p.x + q.x, p.y + q.y, p.z + q.z}));
        }
        return at->second;
    };
    Faces finer;
    for (const auto& [a, b, c] : faces) {
        const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    faces = std::move(finer);
}

// n x n squares; `at` maps (i, j) in 0..n to a vertex.
template <class At>
void add_squares(Mesh& mesh, int n, const At& at) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const auto row = static_cast<std::uint32_t>(n + 1);
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) mesh.positions.push_back(at(i, j));
    for (std::uint32_t j = 0; j + 1 < row; ++j) {
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t a = first + j * row + i, b = a + 1, c = b + row, d = a + row;
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
        }
    }
}

}  // namespace

Mesh star_mesh(int subdivisions, float radius, Vec3 center, float roughness, std::uint64_t seed) {
    std::vector<Point> points{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    Faces faces{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (Point& p : points) p = turned(p);
    for (int s = 0; s < subdivisions; ++s) subdivide(points, faces);
    Mesh mesh;
    recipe::Random random(seed, 0);
    for (const Point& p : points) {
        const double r = double{radius} * (1.0 - double{roughness} * double{random.unit()});
        mesh.positions.push_back(rounded({center.x + r * p.x, center.y + r * p.y, center.z + r * p.z}));
    }
    mesh.triangles = std::move(faces);
    return mesh;
}

Mesh tube_mesh(int narrow, float width, float height) {
    constexpr int wide = 64;
    Mesh mesh;
    const auto n = static_cast<std::uint32_t>(narrow + wide);
    const auto angle_of = [&](std::uint32_t i) {
        const double strip = narrow * double{width};
        const int past = static_cast<int>(i) - narrow;
        return past < 0 ? i * double{width} : strip + past * (2.0 * M_PI - strip) / wide;
    };
    for (const double z : {-0.5, 0.5}) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const double angle = angle_of(i);
            mesh.positions.push_back(rounded(turned({std::cos(angle), std::sin(angle), z * double{height}})));
        }
        mesh.positions.push_back(rounded(turned({0.0, 0.0, z * double{height}})));
    }
    const std::uint32_t top = n + 1;
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t j = (i + 1) % n;
        mesh.triangles.insert(mesh.triangles.end(), {{i, j, top + j}, {i, top + j, top + i}});
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t j = (i + 1) % n;
        mesh.triangles.insert(mesh.triangles.end(), {{j, i, n}, {top + i, top + j, top + n}});
    }
    return mesh;
}

Mesh cube_mesh(int n) {
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const float plane : {-1.0f, 1.0f}) {
            add_squares(mesh, n, [&](int i, int j) {
                const float u = -1.0f + 2.0f * static_cast<float>(i) / static_cast<float>(n);
                const float v = -1.0f + 2.0f * static_cast<float>(j) / static_cast<float>(n);
                Vec3 p{plane, plane, plane};
                p[(axis + 1) % 3] = plane * u, p[(axis + 2) % 3] = v;
                return p;
            });
        }
    }
    return mesh;
}

Mesh floor_mesh(int n, float side) {
    Mesh mesh;
    add_squares(mesh, n, [&](int i, int j) {
        const double x = (double(i) / n - 0.5) * double{side}, y = (double(j) / n - 0.5) * double{side};
        return rounded({x, y, 0.25 * x - 0.5 * y});
    });
    return mesh;
}

void append(Mesh& mesh, const Mesh& other) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
    for (const auto& [a, b, c] : other.triangles) mesh.triangles.push_back({first + a, first + b, first + c});
}

Scene stress_scene(Mesh mesh, std::vector<SphereShape> spheres) {
    Scene scene;
    scene.source = SceneSource::stand_in;
    scene.mesh = std::move(mesh);
    scene.mesh.material.assign(scene.mesh.triangles.size(), 0);
    scene.spheres = std::move(spheres);
    scene.materials.push_back({});
    scene.content_hash = content_hash(scene);
    return scene;
}

}  // namespace ctpbench
