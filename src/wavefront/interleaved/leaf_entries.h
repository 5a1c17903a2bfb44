// The references of a leaf, made into blocks: by type, each primitive once, in the order of their ids.
#pragma once

#include <algorithm>
#include <array>
#include <span>

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
                Indices& of_type = indices_[index_of<typename decltype(tag)::type, Types>];
                of_type.index[of_type.count++] = ref.index;
            });
        for (Indices& of_type : indices_) {
            std::sort(of_type.begin(), of_type.end());
            of_type.count =
                static_cast<std::uint32_t>(std::unique(of_type.begin(), of_type.end()) - of_type.begin());
        }
    }

    std::uint32_t blocks(std::uint32_t position) const {
        return (indices_[position].count + kBlock - 1) / kBlock;
    }
    std::uint32_t blocks() const {
        std::uint32_t total = 0;
        for (std::uint32_t t = 0; t < Types::size; ++t) total += blocks(t);
        return total;
    }
    // The position of the one type that there is.
    std::uint32_t only_type() const {
        for (std::uint32_t t = 0; t < Types::size; ++t)
            if (indices_[t].count > 0) return t;
        trap();
    }
    // Calls f(block, position of its type) for each, in order.
    template <class F>
    void for_each_block(const GeometryView& geometry, F&& f) const {
        for_each_type(Types{}, [&](auto tag) {
            using T = typename decltype(tag)::type;
            using Block = First<BlocksOf<TypeList<T>>>;
            const Indices& of_type = indices_[index_of<T, Types>];
            for (std::uint32_t begin = 0; begin < of_type.count; begin += kBlock) {
                Block block;
                for (std::uint32_t lane = 0; lane < kBlock; ++lane)
                    block.set(lane, geometry, of_type.index[std::min(begin + lane, of_type.count - 1)]);
                f(block, std::uint32_t{index_of<T, Types>});
            }
        });
    }

private:
    struct Indices {
        std::uint32_t index[255];  // SbvhSettings::max_leaf is at most that
        std::uint32_t count = 0;

        std::uint32_t* begin() { return index; }
        std::uint32_t* end() { return index + count; }
    };
    std::array<Indices, Types::size> indices_;
};

}  // namespace ctpbench
