// Paths that leave a surface from where shading found it to be: a policy of offsets must neither hit that
// surface again, nor lose what the path would have hit, nor carry it through a wall.
#include <cmath>
#include <memory>

#include "kernels/surface.h"
#include "stress/aim.h"
#include "stress/families.h"
#include "stress/meshes.h"

namespace ctpbench {
namespace {

enum class Side { outer, inner, either };

// The cosine of a path to its normal is at least this: below, the far side of a sphere is within rounding.
constexpr float kLeastCosine = 0.01f;

GeometryView view_of(const Scene& scene) {
    return {scene.mesh.positions.data(),
            scene.mesh.triangles.data(),
            scene.spheres.data(),
            static_cast<std::uint32_t>(scene.mesh.triangles.size()),
            static_cast<std::uint32_t>(scene.spheres.size()),
            0.0f};
}

// The path goes on to the side of the shading normal, which faces the ray that came.
Departure leave(const GeometryView& geometry, const Ray& came, const Hit& hit, recipe::Random& random) {
    const Surface surface = surface_at(geometry, came, hit);
    Departure d;
    d.primitive = hit.primitive;
    d.point = surface.point;
    d.normal = surface.normal;
    d.t = hit.t;
    const float u1 = random.unit() * (1.0f - kLeastCosine * kLeastCosine), u2 = random.unit();
    d.direction = normalize(cosine_direction(surface.normal, u1, u2));
    return d;
}

// From a point inside a triangle, reached on a way of about `reach`.
Departure leave_triangle(const GeometryView& geometry, std::uint32_t id, Side side, float reach,
                         recipe::Random& random) {
    const TriangleShape s = geometry.triangle(id);
    // Inside by a ten-thousandth of its size at each edge, so that the offset of the point does not decide on
    // which side of a neighbour it is.
    float u = random.unit(), v = random.unit();
    if (u + v > 1.0f) u = 1.0f - u, v = 1.0f - v;
    u = 1e-4f + 0.9997f * u, v = 1e-4f + 0.9997f * v;
    const Vec3 outward = normalize(cross(s.b - s.a, s.c - s.a));
    const bool outer = side == Side::outer || (side == Side::either && random.below(2) == 0);
    const Vec3 from = direction_about(outer ? outward : -outward, random.between(0.1f, 1.0f), random.unit());
    Departure d =
        leave(geometry, ray_along({0, 0, 0}, -from), {reach * random.between(0.1f, 2.0f), id, u, v}, random);
    for (int a = 0; a < 3; ++a) {
        const double at = s.a[a], b = s.b[a], c = s.c[a];
        d.exact[static_cast<std::size_t>(a)] = at + (double{u} * (b - at) + double{v} * (c - at));
    }
    return d;
}

// From a point of a sphere, reached by a ray from outside or inside.
Departure leave_sphere(const GeometryView& geometry, Side side, recipe::Random& random) {
    const SphereShape s = geometry.spheres[0];
    const Vec3 target = s.center + s.radius * random.direction();
    const Vec3 outward = normalize(target - s.center);
    const float distance = s.radius * random.between(0.1f, 0.9f);
    const float cosine = random.between(0.5f, 1.0f);
    const Vec3 from = direction_about(side == Side::outer ? outward : -outward, cosine, random.unit());
    const Ray came = ray_along(target + distance * from, -from);
    Departure d = leave(geometry, came, {distance, 0, 0, 0}, random);
    double f[3], norm = 0.0;
    for (int a = 0; a < 3; ++a) f[a] = double{d.point[a]} - double{s.center[a]}, norm += f[a] * f[a];
    norm = std::sqrt(norm);
    for (int a = 0; a < 3; ++a)
        d.exact[static_cast<std::size_t>(a)] = double{s.center[a]} + double{s.radius} * (f[a] / norm);
    return d;
}

StressWorkload of_mesh(Mesh mesh, std::uint32_t left_from, Side side, float reach, std::uint64_t seed) {
    StressWorkload w;
    w.scene = stress_scene(std::move(mesh));
    w.surfaces.assign(w.scene.mesh.triangles.size(), 0);
    w.departure = [scene = std::make_shared<const Scene>(w.scene), left_from, side, reach,
                   seed](std::uint32_t i) {
        recipe::Random random = ray_random(seed, i);
        const std::uint32_t id = random.below(left_from);
        return leave_triangle(view_of(*scene), id, side, reach, random);
    };
    return w;
}

StressWorkload ball(float radius, float shift, Side side, std::uint64_t seed) {
    Mesh mesh = star_mesh(3, radius, {shift, -shift, shift}, 0.0f, seed);
    const auto triangles = static_cast<std::uint32_t>(mesh.triangles.size());
    return of_mesh(std::move(mesh), triangles, side, radius, seed);
}

StressWorkload sphere(float radius, float shift, Side side, std::uint64_t seed) {
    StressWorkload w;
    w.scene = stress_scene({}, {{{shift, -shift, shift}, radius}});
    w.surfaces = {0};
    w.departure = [scene = std::make_shared<const Scene>(w.scene), side, seed](std::uint32_t i) {
        recipe::Random random = ray_random(seed, i);
        return leave_sphere(view_of(*scene), side, random);
    };
    return w;
}

// Two walls 2^-14 apart in a room, left from the first to both sides; both within [-1, 1]. The first is flat
// exactly and smaller, so that a path from it meets no rim.
StressWorkload walls(std::uint64_t seed) {
    Mesh mesh = floor_mesh(4, 0.5f);
    const auto left_from = static_cast<std::uint32_t>(mesh.triangles.size());
    std::vector<std::uint32_t> surfaces(mesh.triangles.size(), 0);
    const TriangleShape t = mesh.triangle(0);
    const Vec3 normal = normalize(cross(t.b - t.a, t.c - t.a));
    Mesh second = floor_mesh(4, 1.0f);
    for (Vec3& p : second.positions) p = p + 0x1p-14f * normal;
    append(mesh, second);
    surfaces.resize(mesh.triangles.size(), 1);
    Mesh room = cube_mesh(4);
    for (Vec3& p : room.positions) p = 2.0f * p;
    append(mesh, room);
    surfaces.resize(mesh.triangles.size(), 2);
    StressWorkload w = of_mesh(std::move(mesh), left_from, Side::either, 0.5f, seed);
    w.surfaces = std::move(surfaces);
    return w;
}

}  // namespace

std::vector<StressInfo> departure_workloads() {
    std::vector<StressInfo> list;
    const auto add = [&](const char* name, const char* provokes, auto make) {
        list.push_back({name, provokes, kOfOffsets, make});
    };
    const auto balls = [&](const char* name, const char* provokes, float radius, float shift, Side side) {
        add(name, provokes, [=](std::uint64_t seed) { return ball(radius, shift, side, seed); });
    };
    const auto spheres = [&](const char* name, const char* provokes, float radius, float shift, Side side) {
        add(name, provokes, [=](std::uint64_t seed) { return sphere(radius, shift, side, seed); });
    };
    balls("leave_ball", "paths outwards from a convex mesh must hit nothing", 1.0f, 0.0f, Side::outer);
    balls("leave_ball_x1e3", "the same of radius 1e3: a fixed distance is less than an ulp", 1e3f, 0.0f,
          Side::outer);
    balls("leave_ball_at_1e4", "the same at 1e4: neighbours share the rounding of the point", 1.0f, 1e4f,
          Side::outer);
    balls("cross_ball", "paths inwards must hit the other side of a convex mesh", 1.0f, 0.0f, Side::inner);
    balls("cross_ball_x1e-3", "the same of radius 1e-3: a fixed distance is a tenth of it", 1e-3f, 0.0f,
          Side::inner);
    spheres("leave_sphere", "paths outwards from a sphere must hit nothing", 1.0f, 0.0f, Side::outer);
    spheres("leave_sphere_x1e3", "the same of radius 1e3", 1e3f, 0.0f, Side::outer);
    spheres("leave_sphere_at_1e4", "the same at 1e4", 1.0f, 1e4f, Side::outer);
    spheres("cross_sphere", "paths inwards must hit the far side of the same sphere", 1.0f, 0.0f,
            Side::inner);
    spheres("cross_sphere_x1e-3", "the same of radius 1e-3", 1e-3f, 0.0f, Side::inner);
    add("thin_walls", "paths between two walls 2^-14 apart, which too long an offset jumps over", walls);
    return list;
}

}  // namespace ctpbench
