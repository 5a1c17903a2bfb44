#include "wavefront/interleaved/intersector.h"

#include <algorithm>
#include <utility>

#include "wavefront/interleaved/arena.h"
#include "wavefront/interleaved/code.h"
#include "wavefront/interleaved/leaf_writers.h"
#include "wavefront/type_choice.h"

namespace ctpbench {
namespace {

struct Code {
    TraceInFlight (*trace)(LeafKind leaves, std::uint32_t types);
    ConstructBlock construct;
};
Code code_of(const std::string& isa) {
    Code code{};
    visit_isa(isa, [&](auto tag) {
        using Isa = typename decltype(tag)::type;
        code = {InterleavedCode<Isa>::trace, InterleavedCode<Isa>::construct};
    });
    if (code.trace == nullptr) trap();
    return code;
}

// One pass over the rays, through one tree.
struct Pass {
    WideView tree;
    TraceInFlight trace;

    void run(CpuBackend& backend, const IntersectBuffers& io, PassKind kind) const {
        struct Shared {
            const Pass& pass;
            const IntersectBuffers& io;
            PassKind kind;
        };
        const Shared shared{*this, io, kind};
        const bool segmented = io.segment_counts != nullptr;
        backend.for_each_chunk(
            segmented ? io.segments : io.count, segmented ? kMaxChunk / kSegment : kMaxChunk,
            [](const void* p, std::uint32_t begin, std::uint32_t end) {
                const auto& s = *static_cast<const Shared*>(p);
                s.pass.trace(s.pass.tree, s.io, s.kind, begin, end);
            },
            &shared);
    }
};

void miss_all(CpuBackend& backend, const IntersectBuffers& io) {
    if (io.segment_counts == nullptr)
        backend.for_each(io.count, MissKernel{io});
    else
        backend.for_each_in_segments(io.segments, kSegment, io.segment_counts, MissKernel{io});
}

class InterleavedIntersector final : public Intersector {
public:
    InterleavedIntersector(CpuBackend& backend, const GeometryView& geometry, const Code& code)
        : backend_(backend), geometry_(geometry), code_(code) {}

    // Adds a pass, unless there is nothing in its tree.
    template <class Types>
    void add(const InterleavedStrategy& strategy, const TreeView& tree) {
        if (tree.ref_count == 0) return;
        visit_type<LeafKinds<Types>>(static_cast<std::uint32_t>(strategy.leaves), [&](auto tag) {
            using Leaves = typename decltype(tag)::type;
            if constexpr (std::is_same_v<Leaves, VirtualBlocks<BlocksOf<Types>>>)
                lay_out<Types>(strategy, tree,
                               LeafWriter<Leaves, Types>(code_.construct, strategy.objects_together));
            else
                lay_out<Types>(strategy, tree, LeafWriter<Leaves, Types>());
        });
    }

    void intersect(CpuBackend& backend, const IntersectBuffers& io, bool carry_t) const override {
        if (passes_.empty()) return miss_all(backend, io);
        for (std::size_t i = 0; i < passes_.size(); ++i) {
            IntersectBuffers pass = io;
            if (i + 1 < passes_.size()) pass.keys = {};  // hits are not final yet
            passes_[i].run(backend, pass,
                           i == 0    ? PassKind::only
                           : carry_t ? PassKind::bound
                                     : PassKind::fresh);
        }
    }
    std::size_t bytes() const override { return bytes_; }

private:
    template <class Types, class Writer>
    void lay_out(const InterleavedStrategy& strategy, const TreeView& tree, Writer&& writer) {
        struct Memory {
            std::remove_cvref_t<Writer> writer;  // objects are its own
            Arena<Types, std::remove_cvref_t<Writer>> arena;
        };
        CollapseCosts costs;
        costs.single_type_leaves = strategy.tree != TreeKind::mixed;
        backend_.execute([&] {
            auto memory = std::make_shared<Memory>(Memory{std::move(writer), {}});
            memory->arena.build(collapse(tree, costs), tree, geometry_, memory->writer);
            passes_.push_back({memory->arena.view(), code_.trace(strategy.leaves, mask_of<Types>)});
            bytes_ += memory->arena.bytes() + memory->writer.object_bytes();
            memory_.push_back(std::move(memory));
        });
    }

    CpuBackend& backend_;
    GeometryView geometry_;
    Code code_;
    std::vector<Pass> passes_;
    std::vector<std::shared_ptr<void>> memory_;
    std::size_t bytes_ = 0;
};

}  // namespace

std::vector<StrategyInfo> interleaved_strategies() {
    std::vector<StrategyInfo> all;
    for (const InterleavedStrategy& s : kInterleavedStrategies) all.push_back({s.name, s.tree});
    return all;
}

bool traverses(const std::string& strategy, const std::string& traversal, const std::string& backend) {
    const auto among = [&](const std::vector<StrategyInfo>& all) {
        return std::any_of(all.begin(), all.end(), [&](const StrategyInfo& s) { return s.name == strategy; });
    };
    if (traversal == kInterleaved) return backend == "cpu" && among(interleaved_strategies());
    return traversal != kSingle || among(intersect_strategies());
}

std::string interleaved_obstacle(const std::string& methods, const std::string& types) {
    const std::string of_single = std::string("; choose traversal \"") + kSingle + "\", or leave it out";
    if (methods != Watertight::name)
        return std::string("traversal \"") + kInterleaved + "\" is built for methods \"" + Watertight::name +
               "\" alone, not for \"" + methods + "\"" + of_single;
    if (type_choice(types).synthetic.any())
        return std::string("traversal \"") + kInterleaved + "\" is not built for types \"" + types + "\"" +
               of_single;
    return {};
}

std::unique_ptr<Intersector> make_interleaved(CpuBackend& backend, std::string_view strategy,
                                              const LayoutInput& input, const std::string& isa) {
    auto made = std::make_unique<InterleavedIntersector>(backend, input.geometry, code_of(isa));
    const auto* known = std::find_if(std::begin(kInterleavedStrategies), std::end(kInterleavedStrategies),
                                     [&](const InterleavedStrategy& s) { return s.name == strategy; });
    if (known == std::end(kInterleavedStrategies)) trap();
    visit_filtered<Primitives<Watertight>>(input.types, [&](auto list) {
        using Types = typename decltype(list)::type;
        if (known->tree == TreeKind::mixed)
            made->template add<Types>(*known, input.mixed);
        else if (known->tree == TreeKind::typed_leaves)
            made->template add<Types>(*known, input.typed_leaves);
        else
            for_each_type(Types{}, [&](auto tag) {
                using T = typename decltype(tag)::type;
                made->template add<TypeList<T>>(*known, input.per_type.at(primitive_tag<T>));
            });
    });
    return made;
}

}  // namespace ctpbench
