// How each kind of leaves (kernels/interleaved/leaves.h) is written.
#pragma once

#include <cstring>
#include <memory>
#include <new>
#include <vector>

#include "kernels/interleaved/strategies.h"
#include "wavefront/interleaved/leaf_entries.h"

namespace ctpbench {

template <class Leaves, class Types>
class LeafWriter;

template <class Blocks, bool phases, class Types>
class LeafWriter<TypedBlocks<Blocks, phases>, Types> {
public:
    static constexpr bool kInOrder = false;

    std::size_t object_bytes() const { return 0; }
    std::uint32_t bytes(const LeafEntries<Types>& leaf) const {
        return leaf.blocks() * detail::size_of_block(Blocks{}, leaf.only_type());
    }
    std::uint32_t kind(const LeafEntries<Types>& leaf) const { return kFirstLeaf + leaf.only_type(); }
    void write(const LeafEntries<Types>& leaf, std::byte* at, const GeometryView& geometry) const {
        leaf.for_each_block(geometry, [&](const auto& block, std::uint32_t) {
            std::memcpy(at, &block, sizeof block);
            at += sizeof block;
        });
    }
};

template <class Blocks, class Sum, class Visit, class Types>
class LeafWriter<SumTypeBlocks<Blocks, Sum, Visit>, Types> {
public:
    static constexpr bool kInOrder = false;

    std::size_t object_bytes() const { return 0; }
    using Element = typename SumTypeBlocks<Blocks, Sum, Visit>::Element;
    std::uint32_t bytes(const LeafEntries<Types>& leaf) const { return leaf.blocks() * sizeof(Element); }
    std::uint32_t kind(const LeafEntries<Types>&) const { return kFirstLeaf; }
    void write(const LeafEntries<Types>& leaf, std::byte* at, const GeometryView& geometry) const {
        leaf.for_each_block(geometry, [&](const auto& block, std::uint32_t) {
            new (at) Element{Sum(block)};
            at += sizeof(Element);
        });
    }
};

// Of a list of primitives, as LayoutInput::types has it.
template <class Types>
inline constexpr std::uint32_t mask_of = [] {
    std::uint32_t mask = 0;
    for_each_type(Types{}, [&](auto tag) { mask |= 1u << primitive_tag<typename decltype(tag)::type>; });
    return mask;
}();

// Constructs the object of a block in memory, as InterleavedCode::construct does.
using ConstructBlock = void* (*)(std::uint32_t types, std::uint32_t position, const void* block,
                                 void* memory);

// Leaves of pointers to objects. The objects are the writer's, and need no destructor.
template <class Blocks, class Types>
class LeafWriter<VirtualBlocks<Blocks>, Types> {
public:
    static constexpr bool kInOrder = true;

    // `together`: objects lie in the order in which leaves are written, else each in an allocation of its
    // own.
    LeafWriter(ConstructBlock construct, bool together) : construct_(construct), together_(together) {}

    std::uint32_t bytes(const LeafEntries<Types>&) const { return kUnit; }
    std::uint32_t kind(const LeafEntries<Types>&) const { return kFirstLeaf; }
    void write(const LeafEntries<Types>& leaf, std::byte* at, const GeometryView& geometry) {
        void** const pointers = reinterpret_cast<void**>(at);
        std::uint32_t left = leaf.blocks();
        leaf.for_each_block(geometry, [&](const auto& block, std::uint32_t position) {
            using Block = std::remove_cvref_t<decltype(block)>;
            // The instruction set is of no matter to the size.
            constexpr std::size_t size = sizeof(BlockObject<ScalarIsa, Blocks, Block>);
            pointers[--left] = construct_(mask_of<Types>, position, &block, allocate(size));
        });
    }
    std::size_t object_bytes() const { return bytes_; }

private:
    static constexpr std::size_t kPool = std::size_t{1} << 20;
    struct Free {
        void operator()(void* p) const { ::operator delete (p, std::align_val_t{kUnit}); }
    };

    void* allocate(std::size_t size) {
        bytes_ += size;
        if (!together_) return fresh(size);
        if (used_ + size > kPool) pool_ = static_cast<std::byte*>(fresh(kPool)), used_ = 0;
        used_ += size;
        return pool_ + used_ - size;
    }
    void* fresh(std::size_t size) {
        return memory_.emplace_back(::operator new (size, std::align_val_t{kUnit})).get();
    }

    ConstructBlock construct_;
    bool together_;
    std::vector<std::unique_ptr<void, Free>> memory_;
    std::byte* pool_ = nullptr;
    std::size_t used_ = kPool, bytes_ = 0;
};

}  // namespace ctpbench
