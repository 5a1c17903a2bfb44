// What a leaf of the 8-wide tree is to each strategy, and how it branches on the type of a block. All of them
// share the steps through nodes (flight.h); the price of a branch is what differs.
//
// A kind of leaves has:
//   kLists                   how many lists of rays at leaves there are: a list is a loop of its own
//   list_of(kind)            in which list a ray waits that has come to this kind of place; nodes, ends
//                            and hits have lists too, with the numbers of their kinds
//   test<Isa, list>(...)     the nearest hit of the block that a word names
//   stride(word)             from that block to the next one of the leaf, in bytes
//   resolve(...)             all that there is to know of a hit, once the ray has ended
//   test_packet<Isa>(...)    tests all blocks of a leaf with a packet of rays
#pragma once

#include "../variant.h"
#include "blocks.h"
#include "node.h"

namespace ctpbench {

// What the tests of all types derive from a ray.
template <class Block>
using SetupOf = typename Block::Setup;
template <class Blocks>
using Setups = PerType<SetupOf, Blocks>;

template <class Block>
CTP_INLINE const Block& block_at(const std::byte* at) {
    return *reinterpret_cast<const Block*>(at);
}

namespace detail {
template <class... Blocks>
CTP_INLINE std::uint32_t size_of_block(TypeList<Blocks...>, std::uint32_t type) {
    constexpr std::uint32_t sizes[] = {sizeof(Blocks)...};
    return sizes[type];
}
}  // namespace detail

// A leaf holds one type, which its word names. With `phases` each type has a list of its own: the branch is
// paid once for all rays that are at leaves of a type. Else there is one list, and a branch for each block.
template <class BlockList, bool phases>
struct TypedBlocks {
    using Blocks = BlockList;
    static constexpr std::uint32_t kLists = phases ? Blocks::size : 1;
    static constexpr bool kOneType = Blocks::size == 1;

    CTP_INLINE static std::uint32_t list_of(std::uint32_t kind) {
        return phases || kind < kFirstLeaf ? kind : kFirstLeaf;
    }
    CTP_INLINE static std::uint32_t stride(std::uint32_t word) {
        if constexpr (kOneType) return sizeof(First<Blocks>);
        return detail::size_of_block(Blocks{}, kind_of_word(word) - kFirstLeaf);
    }
    template <class Isa, std::uint32_t list>
    CTP_INLINE static BlockHit test(const std::byte* at, std::uint32_t word, const Setups<Blocks>& setups) {
        BlockHit hit;
        visit(phases || kOneType ? list : kind_of_word(word) - kFirstLeaf, [&](auto tag) {
            using Block = typename decltype(tag)::type;
            hit = block_at<Block>(at).template intersect<Isa>(setups.template of<Block>());
        });
        return hit;
    }
    template <class Isa>
    CTP_INLINE static Hit resolve(const std::byte* at, std::uint32_t word, std::uint32_t lane, float t,
                                  const Setups<Blocks>& setups) {
        Hit hit;
        visit(kind_of_word(word) - kFirstLeaf, [&](auto tag) {
            using Block = typename decltype(tag)::type;
            hit = block_at<Block>(at).resolve(lane, t, setups.template of<Block>());
        });
        return hit;
    }

    template <class Isa>
    CTP_INLINE static void test_packet(const std::byte* at, std::uint32_t word,
                                       PacketRays<Isa, Blocks>& rays) {
        visit(kind_of_word(word) - kFirstLeaf, [&](auto tag) {
            using Block = typename decltype(tag)::type;
            for (std::uint32_t i = 0; i <= more_blocks(word); ++i)
                rays.test(block_at<Block>(at + i * sizeof(Block)));
        });
    }

private:
    template <class F>
    CTP_INLINE static void visit(std::uint32_t type, F&& f) {
        if constexpr (kOneType)
            f(TypeTag<First<Blocks>>{});
        else
            visit_type<Blocks>(type, f);
    }
};

// A leaf holds sums of the types of blocks: Visit{}(visitor, element) finds the type of each.
template <class BlockList, class Sum, class Visit>
struct SumTypeBlocks {
    using Blocks = BlockList;
    struct alignas(kUnit) Element {
        Sum sum;
    };
    static constexpr std::uint32_t kLists = 1;

    CTP_INLINE static std::uint32_t list_of(std::uint32_t kind) { return kind; }
    CTP_INLINE static std::uint32_t stride(std::uint32_t) { return sizeof(Element); }
    template <class Isa, std::uint32_t>
    CTP_INLINE static BlockHit test(const std::byte* at, std::uint32_t, const Setups<Blocks>& setups) {
        return Visit{}(
            [&](const auto& block) {
                return block.template intersect<Isa>(
                    setups.template of<std::remove_cvref_t<decltype(block)>>());
            },
            block_at<Element>(at).sum);
    }
    template <class Isa>
    CTP_INLINE static Hit resolve(const std::byte* at, std::uint32_t, std::uint32_t lane, float t,
                                  const Setups<Blocks>& setups) {
        return Visit{}(
            [&](const auto& block) {
                return block.resolve(lane, t, setups.template of<std::remove_cvref_t<decltype(block)>>());
            },
            block_at<Element>(at).sum);
    }
    template <class Isa>
    CTP_INLINE static void test_packet(const std::byte* at, std::uint32_t word,
                                       PacketRays<Isa, Blocks>& rays) {
        for (std::uint32_t i = 0; i <= more_blocks(word); ++i)
            Visit{}([&](const auto& block) { rays.test(block); },
                    block_at<Element>(at + i * sizeof(Element)).sum);
    }
};

// A block behind a virtual call.
template <class Isa, class Blocks>
class BlockBase {
public:
    virtual ~BlockBase() = default;
    virtual BlockHit intersect(const Setups<Blocks>& setups) const = 0;
    virtual Hit resolve(std::uint32_t lane, float t, const Setups<Blocks>& setups) const = 0;
    virtual void test(PacketRays<Isa, Blocks>& rays) const = 0;
};
template <class Isa, class Blocks, class Block>
class BlockObject final : public BlockBase<Isa, Blocks> {
public:
    explicit BlockObject(const Block& block) : block_(block) {}
    BlockHit intersect(const Setups<Blocks>& setups) const override {
        return block_.template intersect<Isa>(setups.template of<Block>());
    }
    Hit resolve(std::uint32_t lane, float t, const Setups<Blocks>& setups) const override {
        return block_.resolve(lane, t, setups.template of<Block>());
    }
    void test([[maybe_unused]] PacketRays<Isa, Blocks>& rays) const override {
        if constexpr (Lanes<Isa>::width > 0) rays.test(block_);
    }

private:
    Block block_;
};

// A leaf holds pointers to objects, the last one first: as many as fit a unit.
template <class BlockList>
struct VirtualBlocks {
    using Blocks = BlockList;
    static constexpr std::uint32_t kLists = 1;
    static_assert(kMaxLeafBlocks * sizeof(void*) <= kUnit);

    CTP_INLINE static std::uint32_t list_of(std::uint32_t kind) { return kind; }
    CTP_INLINE static std::uint32_t stride(std::uint32_t) { return 0; }
    template <class Isa>
    CTP_INLINE static const BlockBase<Isa, Blocks>& object(const std::byte* at, std::uint32_t word) {
        return *reinterpret_cast<const BlockBase<Isa, Blocks>* const*>(at)[more_blocks(word)];
    }
    template <class Isa, std::uint32_t>
    CTP_INLINE static BlockHit test(const std::byte* at, std::uint32_t word, const Setups<Blocks>& setups) {
        return object<Isa>(at, word).intersect(setups);
    }
    template <class Isa>
    CTP_INLINE static Hit resolve(const std::byte* at, std::uint32_t word, std::uint32_t lane, float t,
                                  const Setups<Blocks>& setups) {
        return object<Isa>(at, word).resolve(lane, t, setups);
    }
    template <class Isa>
    CTP_INLINE static void test_packet(const std::byte* at, std::uint32_t word,
                                       PacketRays<Isa, Blocks>& rays) {
        for (std::uint32_t i = 0; i <= more_blocks(word); ++i)
            object<Isa>(at, word - i * kOneBlock).test(rays);
    }
};

}  // namespace ctpbench
