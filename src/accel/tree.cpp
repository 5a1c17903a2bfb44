#include "accel/tree.h"

// GCC 12 warns about its own AVX-512 intrinsics once they are inlined here; the hash is the same.
#define XXH_VECTOR 0
#define XXH_INLINE_ALL
#include <xxhash.h>

#include "accel/parallel.h"

namespace ctpbench {

float sah_cost(const Tree& tree) {
    if (tree.nodes.empty()) return 0.0f;
    const double root = tree.nodes[0].box().half_area();
    // A ray that meets a root without area meets everything in it.
    const double cost = reduce_in_chunks<double>(
        tree.nodes.size(),
        [&](std::size_t begin, std::size_t end, double& sum) {
            for (std::size_t i = begin; i < end; ++i) {
                if (i == 1) continue;
                const BvhNode& node = tree.nodes[i];
                const double share = root > 0.0 ? node.box().half_area() / root : 1.0;
                sum += share * (node.is_leaf() ? node.count() : 1);
            }
        },
        [](double& into, double from) { into += from; });
    return static_cast<float>(cost);
}

std::uint64_t hash(const Tree& tree) {
    const std::uint64_t nodes = XXH3_64bits(tree.nodes.data(), tree.nodes.size() * sizeof(BvhNode));
    return XXH3_64bits_withSeed(tree.refs.data(), tree.refs.size() * sizeof(PrimitiveRef), nodes);
}

}  // namespace ctpbench
