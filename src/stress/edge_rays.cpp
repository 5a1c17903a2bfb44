#include "stress/edge_rays.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "stress/aim.h"

namespace ctpbench {
namespace {

struct Edge {
    Vec3 from, to;
    std::uint32_t triangle, corner;
};

std::tuple<float, float, float> key(Vec3 p) { return {p.x, p.y, p.z}; }
bool before(const Edge& a, const Edge& b) {
    return std::tuple(key(a.from), key(a.to)) < std::tuple(key(b.from), key(b.to));
}

// Of each triangle, bit k is set if its edge from corner k is shared by two triangles.
std::vector<std::uint8_t> inner_edges(const Mesh& mesh) {
    std::vector<Edge> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& t = mesh.triangles[i];
        for (std::uint32_t k = 0; k < 3; ++k) {
            Vec3 a = mesh.positions[t[k]], b = mesh.positions[t[(k + 1) % 3]];
            if (key(b) < key(a)) std::swap(a, b);
            edges.push_back({a, b, i, k});
        }
    }
    std::sort(edges.begin(), edges.end(), before);
    std::vector<std::uint8_t> inner(mesh.triangles.size(), 0);
    for (std::size_t first = 0, last; first < edges.size(); first = last) {
        last = first + 1;
        while (last < edges.size() && !before(edges[first], edges[last])) ++last;
        for (std::size_t e = first; last - first == 2 && e < last; ++e)
            inner[edges[e].triangle] |= static_cast<std::uint8_t>(1u << edges[e].corner);
    }
    return inner;
}

}  // namespace

std::vector<Ray> edge_rays(const Scene& scene, std::span<const Sighting> sightings, std::uint64_t seed,
                           std::uint32_t n) {
    const std::vector<std::uint8_t> inner = inner_edges(scene.mesh);
    std::vector<Sighting> usable;
    for (const Sighting& s : sightings)
        if (s.triangle < inner.size() && inner[s.triangle] != 0) usable.push_back(s);
    std::vector<Ray> rays;
    if (usable.empty()) return rays;
    rays.reserve(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        recipe::Random random = ray_random(seed, i);
        const Sighting& s = usable[random.below(static_cast<std::uint32_t>(usable.size()))];
        std::uint32_t k = random.below(3);
        while ((inner[s.triangle] >> k & 1u) == 0) k = (k + 1) % 3;
        const auto& t = scene.mesh.triangles[s.triangle];
        const Vec3 a = scene.mesh.positions[t[k]], b = scene.mesh.positions[t[(k + 1) % 3]];
        const bool at_vertex = random.below(4) == 0;
        rays.push_back(ray_towards(s.origin, at_vertex ? a : a + random.unit() * (b - a)));
    }
    return rays;
}

}  // namespace ctpbench
