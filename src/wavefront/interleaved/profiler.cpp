#include "wavefront/interleaved/profiler.h"

#include <algorithm>

#include "wavefront/interleaved/arena.h"
#include "wavefront/interleaved/code.h"
#include "wavefront/interleaved/isa.h"
#include "wavefront/interleaved/leaf_writers.h"

namespace ctpbench {

struct FlightProfiler::Tree {
    std::shared_ptr<const void> memory;
    WideView view;
    ProfileInFlight profile = nullptr;
};

FlightProfiler::FlightProfiler(CpuBackend& backend, const LayoutInput& input, const std::string& isa)
    : extent_(input.geometry.extent) {
    auto tree = std::make_shared<Tree>();
    visit_isa(isa, [&](auto tag) {
        tree->profile = InterleavedCode<typename decltype(tag)::type>::profile(input.types);
    });
    visit_filtered<Primitives<Watertight>>(input.types, [&](auto list) {
        using Types = typename decltype(list)::type;
        using Writer = LeafWriter<TypedBlocks<BlocksOf<Types>, true>, Types>;
        CollapseCosts costs;
        costs.single_type_leaves = true;
        auto arena = std::make_shared<Arena<Types, Writer>>();
        Writer writer;
        backend.execute([&] {
            arena->build(collapse(input.typed_leaves, costs), input.typed_leaves, input.geometry, writer);
        });
        tree->view = arena->view();
        tree->memory = arena;
    });
    tree_ = std::move(tree);
}

FlightProfile FlightProfiler::trace(Batch& batch) const {
    FlightProfile profile;
    if (tree_->view.bytes == nullptr) return profile;
    HitStorage hits;
    const IntersectBuffers io = batch_buffers(batch, hits, extent_);
    for (std::uint32_t begin = 0; begin < io.count; begin += kMaxChunk)
        tree_->profile(tree_->view, io, begin, std::min(begin + kMaxChunk, io.count), profile);
    return profile;
}

}  // namespace ctpbench
