// One contender of the intersect stage, ready to trace: a strategy with the layout it traverses. The
// virtual call is one per batch of rays; what a strategy does per primitive is inside.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "backends/cpu.h"
#include "kernels/dispatch/layout.h"
#include "kernels/intersect.h"

namespace ctpbench {

class CountingPlace;

class Intersector {
public:
    virtual ~Intersector() = default;

    // Writes the closest hit of every active ray. `carry_t`: whether a pass is bounded by the hits of the
    // pass before; it concerns strategies of several passes only.
    virtual void intersect(CpuBackend& backend, const IntersectBuffers& io, bool carry_t) const = 0;

    // Whether it heeds IntersectBuffers::excluded.
    virtual bool excludes() const { return false; }

    // Memory of the layout beside the trees it shares.
    virtual std::size_t bytes() const = 0;

    // Lays out the same contender, from the same input, where a device's memory is only counted. Nothing
    // where there is none on a device.
    virtual void count(const LayoutInput&, const CountingPlace&) const {}
};

// A strategy of the registry as the experiment sees it before anything is built.
struct StrategyInfo {
    std::string name;
    TreeKind tree;
};
std::vector<StrategyInfo> intersect_strategies();

// Lays out `strategy` with the methods of this key (wavefront/methods.h), compiled for the input's types.
// There must be such a contender.
std::unique_ptr<Intersector> make_intersector(std::string_view strategy, std::string_view methods,
                                              const LayoutInput& input);

}  // namespace ctpbench
