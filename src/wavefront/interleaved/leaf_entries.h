// The references of a leaf, made into blocks: by type, each primitive once, in the order of their ids.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "kernels/dispatch/layout.h"
#include "kernels/interleaved/blocks.h"

namespace ctpbench {

// Types: those that leaves may hold.
template <class Types>
class LeafEntries {
public:
    // `refs` are kept only as long as this call.
    explicit LeafEntries(std::span<const PrimitiveRef> refs) {
        for (const PrimitiveRef& ref : refs)
            visit_by_tag<Types>(ref.type, [&](auto tag) {
                indices_[index_of<typename decltype(tag)::type, Types>].push_back(ref.index);
            });
        for (std::vector<std::uint32_t>& of_type : indices_) {
            std::sort(of_type.begin(), of_type.end());
            of_type.erase(std::unique(of_type.begin(), of_type.end()), of_type.end());
        }
    }

    std::uint32_t blocks(std::uint32_t position) const {
        return static_cast<std::uint32_t>((indices_[position].size() + kBlock - 1) / kBlock);
    }
    std::uint32_t blocks() const {
        std::uint32_t total = 0;
        for (std::uint32_t t = 0; t < Types::size; ++t) total += blocks(t);
        return total;
    }
    // The position of the one type that there is.
    std::uint32_t only_type() const {
        for (std::uint32_t t = 0; t < Types::size; ++t)
            if (!indices_[t].empty()) return t;
        trap();
    }
    // Calls f(block, position of its type) for each, in order.
    template <class F>
    void for_each_block(const GeometryView& geometry, F&& f) const {
        for_each_type(Types{}, [&](auto tag) {
            using T = typename decltype(tag)::type;
            using Block = First<BlocksOf<TypeList<T>>>;
            const std::vector<std::uint32_t>& indices = indices_[index_of<T, Types>];
            for (std::size_t begin = 0; begin < indices.size(); begin += kBlock) {
                Block block;
                for (std::uint32_t lane = 0; lane < kBlock; ++lane)
                    block.set(lane, geometry, indices[std::min(begin + lane, indices.size() - 1)]);
                f(block, std::uint32_t{index_of<T, Types>});
            }
        });
    }

private:
    std::array<std::vector<std::uint32_t>, Types::size> indices_;
};

}  // namespace ctpbench
