// Contenders of the intersect stage with many rays in flight through an 8-wide tree. They have the default
// methods.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "wavefront/interleaved/isa.h"
#include "wavefront/intersector.h"

namespace ctpbench {

// The values of the axis `traversal`.
inline constexpr const char* kSingle = "single";
inline constexpr const char* kInterleaved = "interleaved";

// Whether a backend has the strategy with this traversal. `typed_phases` takes many rays, and a device has
// them single.
bool traverses(const std::string& strategy, const std::string& traversal, const std::string& backend);

// Why no contender has rays in flight with the methods of this key (wavefront/methods.h) and these types, and
// what can; empty if one has.
std::string interleaved_obstacle(const std::string& methods, const std::string& types);

std::vector<StrategyInfo> interleaved_strategies();

// Collapses the strategy's trees and lays them out, compiled for the input's types and for this instruction
// set, one of usable_isas(). There must be such a strategy. Throws Error(usage) where a tree is too large.
std::unique_ptr<Intersector> make_interleaved(CpuBackend& backend, std::string_view strategy,
                                              const LayoutInput& input, const std::string& isa);

}  // namespace ctpbench
