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

inline constexpr const char* kInterleaved = "interleaved";

std::vector<StrategyInfo> interleaved_strategies();

// Collapses the strategy's trees and lays them out, compiled for the input's types and for this instruction
// set, one of usable_isas(). There must be such a strategy. Throws Error(usage) where a tree is too large.
std::unique_ptr<Intersector> make_interleaved(CpuBackend& backend, std::string_view strategy,
                                              const LayoutInput& input, const std::string& isa);

}  // namespace ctpbench
