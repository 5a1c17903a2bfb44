// The 8-wide tree as it lies in memory: depth first, each node followed by what its leaves hold.
#pragma once

#include <string>
#include <vector>

#include "accel/parallel.h"
#include "accel/wide_tree.h"
#include "base/error.h"
#include "kernels/array.h"
#include "kernels/interleaved/flight.h"
#include "wavefront/interleaved/leaf_entries.h"

namespace ctpbench {

// The farthest child first, as seen along each octant's diagonal.
void set_order(const WideTree::Node& from, WideNode& to);

// Writer: kInOrder, whether leaves are written one after another; bytes(entries) and kind(entries) of a leaf,
// and write(entries, place, geometry).
template <class Types, class Writer>
class Arena {
public:
    // All of these are read in this call only, but for the writer, which may own what leaves refer to.
    void build(const WideTree& wide, const TreeView& tree, const GeometryView& geometry, Writer& writer) {
        if (tree.ref_count == 0) return;
        const auto entries = [&](const WideTree::Child& leaf) {
            return LeafEntries<Types>({tree.refs + leaf.first, leaf.count});
        };
        // Where the record of each node begins; the last is where all end.
        std::vector<std::uint64_t> places(wide.nodes.size() + 1, 0);
        for_each_chunk(wide.nodes.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t n = begin; n < end; ++n) {
                std::uint64_t bytes = sizeof(WideNode);
                for (std::uint32_t i = 0; i < wide.nodes[n].child_count; ++i)
                    if (wide.nodes[n].children[i].count != 0)
                        bytes += writer.bytes(entries(wide.nodes[n].children[i]));
                places[n + 1] = (bytes + alignof(WideNode) - 1) / alignof(WideNode) * alignof(WideNode);
            }
        });
        for (std::size_t n = 0; n < wide.nodes.size(); ++n) places[n + 1] += places[n];
        const std::uint64_t bytes = wide.nodes.empty() ? writer.bytes(entries(wide.root)) : places.back();
        if (bytes > (std::uint64_t{1} << 32) - sizeof(WideNode))
            throw Error(
                ExitCode::usage,
                "traversal \"interleaved\": error: the tree would take " + std::to_string(bytes >> 20) +
                    " MiB, and 4096 MiB is the limit; choose traversal \"single\" or a smaller scene");
        units_.resize(bytes / sizeof(Unit) + 4);  // a step fetches up to four lines ahead
        auto* base = reinterpret_cast<std::byte*>(units_.data());
        const auto write_leaf = [&](const WideTree::Child& leaf, std::uint64_t place) {
            const LeafEntries<Types> of_leaf = entries(leaf);
            if (of_leaf.blocks() > kMaxLeafBlocks)
                throw Error(ExitCode::internal, "a leaf of the 8-wide tree holds " +
                                                    std::to_string(of_leaf.blocks()) + " blocks");
            writer.write(of_leaf, base + place, geometry);
            const auto at = static_cast<std::uint32_t>(place);
            return std::pair{leaf_word_of(at, writer.kind(of_leaf), of_leaf.blocks()), writer.bytes(of_leaf)};
        };
        root_ = wide.nodes.empty() ? write_leaf(wide.root, 0).first : kInner;
        const auto write = [&](std::size_t, std::size_t begin, std::size_t end) {
            for (std::size_t n = begin; n < end; ++n) {
                const WideTree::Node& from = wide.nodes[n];
                auto& to = *reinterpret_cast<WideNode*>(base + places[n]);
                std::uint64_t place = places[n] + sizeof(WideNode);
                set_order(from, to);
                for (std::uint32_t i = 0; i < kWide; ++i) {
                    const bool there = i < from.child_count;
                    const Box box = there ? from.children[i].box : Box::empty();
                    for (int a = 0; a < 3; ++a)
                        to.bounds[a][0][i] = box.lo[a], to.bounds[a][1][i] = box.hi[a];
                    to.children[i] = kDone;
                    if (!there) continue;
                    const WideTree::Child& child = from.children[i];
                    if (child.count == 0) {
                        to.children[i] = static_cast<std::uint32_t>(places[child.first]) | kInner;
                    } else {
                        const auto [word, size] = write_leaf(child, place);
                        to.children[i] = word;
                        place += size;
                    }
                }
            }
        };
        if constexpr (Writer::kInOrder)
            write(0, 0, wide.nodes.size());
        else
            for_each_chunk(wide.nodes.size(), write);
        stack_ = wide.stack + 2;  // the bottom, and the child that is taken at once
    }

    WideView view() const {
        if (units_.empty()) return {};
        return {reinterpret_cast<const std::byte*>(units_.data()), root_, stack_};
    }
    std::size_t bytes() const { return units_.size() * sizeof(Unit); }

private:
    struct alignas(64) Unit {
        std::byte bytes[64];
        Unit() {}  // not zeroed: tasks are the first to touch what they fill
    };
    Array<Unit> units_;
    std::uint32_t root_ = kDone, stack_ = 0;
};

}  // namespace ctpbench
