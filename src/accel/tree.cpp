#include "accel/tree.h"

#include "accel/parallel.h"
#include "base/hash.h"

namespace ctpbench {

float sah_cost(const Tree& tree) {
    if (tree.nodes.empty()) return 0.0f;
    const double root = tree.nodes[0].box().half_area();
    // A ray that meets a root without area meets everything in it.
    const double cost = reduce_in_chunks<double>(
        tree.nodes.size(),
        [&](std::size_t begin, std::size_t end, double& sum) {
            sum = 0;
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

std::uint64_t hash(const Tree& tree) { return hash_vector(tree.refs, hash_vector(tree.nodes)); }

}  // namespace ctpbench
