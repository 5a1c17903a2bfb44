#include "oracle/adjacency.h"

#include <bit>
#include <unordered_map>

#include "base/hash.h"

namespace ctpbench {
namespace {

struct HashPosition {
    std::size_t operator()(const Vec3& p) const {
        // Adding zero makes -0 and 0, which are equal, hash alike.
        const std::uint64_t x = std::bit_cast<std::uint32_t>(p.x + 0.0f);
        const std::uint64_t y = std::bit_cast<std::uint32_t>(p.y + 0.0f);
        const std::uint64_t z = std::bit_cast<std::uint32_t>(p.z + 0.0f);
        std::uint64_t h = (x << 32 | y) * 0x9e3779b97f4a7c15u;
        h = (h ^ h >> 29 ^ z) * 0xbf58476d1ce4e5b9u;
        return h ^ h >> 32;
    }
};

}  // namespace

MeshAdjacency::MeshAdjacency(const GeometryView& geometry) {
    const std::uint32_t count = geometry.triangle_count;
    std::unordered_map<Vec3, std::uint32_t, HashPosition> numbers;
    corners_.reserve(3 * std::size_t{count});
    for (std::uint32_t i = 0; i < count; ++i) {
        const TriangleShape t = geometry.triangle(i);
        for (const Vec3& p : {t.a, t.b, t.c})
            corners_.push_back(
                numbers.try_emplace(p, static_cast<std::uint32_t>(numbers.size())).first->second);
    }
    first_.assign(numbers.size() + 1, 0);
    for (const std::uint32_t v : corners_) ++first_[v + 1];
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    triangles_.resize(corners_.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t c = 0; c < corners_.size(); ++c)
        triangles_[next[corners_[c]]++] = static_cast<std::uint32_t>(c / 3);
}

}  // namespace ctpbench
