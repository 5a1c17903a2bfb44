// The definitions of code.h. Included where an instruction set's code is instantiated, and nowhere else.
#pragma once

#include <new>

#include "wavefront/interleaved/code.h"

namespace ctpbench {

template <class Isa, class Leaves>
void trace_in_flight(const WideView& tree, const IntersectBuffers& io, PassKind pass, std::uint32_t begin,
                     std::uint32_t end) {
    Flight<Isa, Watertight, Leaves>(tree, io, pass).trace(begin, end);
}

template <class Isa>
TraceInFlight InterleavedCode<Isa>::trace(LeafKind leaves, std::uint32_t types) {
    TraceInFlight found = nullptr;
    visit_filtered<Primitives<Watertight>>(types, [&](auto list) {
        using Kinds = LeafKinds<typename decltype(list)::type>;
        visit_type<Kinds>(static_cast<std::uint32_t>(leaves),
                          [&](auto kind) { found = trace_in_flight<Isa, typename decltype(kind)::type>; });
    });
    return found;
}

template <class Isa, class Leaves>
void profile_in_flight(const WideView& tree, const IntersectBuffers& io, std::uint32_t begin,
                       std::uint32_t end, FlightProfile& profile) {
    Flight<Isa, Watertight, Leaves, CycleMeter>(tree, io, PassKind::only, CycleMeter(profile))
        .trace(begin, end);
}

template <class Isa>
ProfileInFlight InterleavedCode<Isa>::profile(std::uint32_t types) {
    ProfileInFlight found = nullptr;
    visit_filtered<Primitives<Watertight>>(types, [&](auto list) {
        found = profile_in_flight<Isa, TypedBlocks<BlocksOf<typename decltype(list)::type>, true>>;
    });
    return found;
}

template <class Isa>
void* InterleavedCode<Isa>::construct(std::uint32_t types, std::uint32_t position, const void* block,
                                      void* memory) {
    void* made = nullptr;
    visit_filtered<Primitives<Watertight>>(types, [&](auto list) {
        using Blocks = BlocksOf<typename decltype(list)::type>;
        visit_type<Blocks>(position, [&](auto tag) {
            using Block = typename decltype(tag)::type;
            BlockBase<Isa, Blocks>* object =
                new (memory) BlockObject<Isa, Blocks, Block>(*static_cast<const Block*>(block));
            made = object;
        });
    });
    return made;
}

}  // namespace ctpbench
