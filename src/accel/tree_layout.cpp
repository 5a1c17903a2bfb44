#include "accel/tree_layout.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>

namespace ctpbench {
namespace {

// Subtrees of fewer inner nodes are copied by one task.
constexpr std::uint32_t kTask = 4096;

class Orderer {
public:
    Orderer(const RawTree& raw, OrderedTree& out) : raw_(raw), out_(out) {}

    // A subtree, where its root goes, and where the pairs and entries below it go.
    struct Place {
        std::uint32_t from, to;
        SubtreeSize size;
        std::uint32_t next_pair, next_entry;
    };

    // Returns the subtree's depth.
    std::uint32_t copy(const Place& at) const {
        BvhNode node = raw_.nodes[at.from];
        if (node.is_leaf()) {
            std::copy_n(raw_.leaf_entries.begin() + node.first, node.count(),
                        out_.entries.begin() + at.next_entry);
            node.first = at.next_entry;
            out_.nodes[at.to] = node;
            return 1;
        }
        const std::uint32_t child = node.first;
        node.first = at.next_pair;
        out_.nodes[at.to] = node;

        const SubtreeSize one = raw_.first_child[child / 2];
        const SubtreeSize other{at.size.inner - 1 - one.inner, at.size.entries - one.entries};
        Place near{child, at.next_pair, one, at.next_pair + 2, at.next_entry};
        Place far{child + 1, at.next_pair + 1, other, at.next_pair + 2, at.next_entry};
        if (raw_.nodes[child].box().half_area() < raw_.nodes[child + 1].box().half_area())
            std::swap(near, far);
        far.next_pair += 2 * near.size.inner;
        far.next_entry += near.size.entries;

        std::uint32_t near_depth, far_depth;
        if (at.size.inner < kTask) {
            near_depth = copy(near);
            far_depth = copy(far);
        } else {
            tbb::parallel_invoke([&] { near_depth = copy(near); }, [&] { far_depth = copy(far); });
        }
        return 1 + std::max(near_depth, far_depth);
    }

private:
    const RawTree& raw_;
    OrderedTree& out_;
};

}  // namespace

OrderedTree order_depth_first(const RawTree& raw) {
    OrderedTree out{NodeArray(raw.size.inner == 0 ? 1 : 2 + 2 * std::size_t{raw.size.inner}),
                    std::vector<std::uint32_t>(raw.size.entries), 0};
    if (out.nodes.size() > 1) out.nodes[1] = BvhNode{};
    out.depth = Orderer(raw, out).copy({0, 0, raw.size, 2, 0});
    return out;
}

}  // namespace ctpbench
