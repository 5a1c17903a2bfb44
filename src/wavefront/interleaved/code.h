// What is compiled for one instruction set, as plain pointers: whoever calls it need not be compiled for it.
#pragma once

#include "kernels/interleaved/flight.h"
#include "kernels/interleaved/strategies.h"

namespace ctpbench {

// Traces the rays at positions (or in the segments) from begin on to end, on the calling thread.
using TraceInFlight = void (*)(const WideView& tree, const IntersectBuffers& io, PassKind pass,
                               std::uint32_t begin, std::uint32_t end);

// The same for the only pass over dense positions, timing its phases.
using ProfileInFlight = void (*)(const WideView& tree, const IntersectBuffers& io, std::uint32_t begin,
                                 std::uint32_t end, FlightProfile& profile);

template <class Isa>
struct InterleavedCode {
    // Of leaves of this kind, compiled for the primitives of the mask.
    static TraceInFlight trace(LeafKind leaves, std::uint32_t types);

    // Of typed_phases.
    static ProfileInFlight profile(std::uint32_t types);

    // Constructs the object of a block, that of the type at this position among those of the mask, in memory
    // that has room for it. Returns it as its BlockBase.
    static void* construct(std::uint32_t types, std::uint32_t position, const void* block, void* memory);
};

}  // namespace ctpbench
