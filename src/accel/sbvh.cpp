#include "accel/sbvh.h"

#include <cmath>
#include <sstream>

#include "accel/object_split.h"
#include "base/error.h"

namespace ctpbench {
namespace {
template <class T>
void require(const char* field, T value, T lowest, T highest) {
    if (value >= lowest && value <= highest) return;
    std::ostringstream message;
    message << "tree builder: " << field << " is " << value << "; give a value from " << lowest << " to "
            << highest;
    throw Error(ExitCode::usage, message.str());
}
}  // namespace

SbvhSettings SbvhSettings::paper() {
    SbvhSettings s;
    s.object_bins = 16;
    s.spatial_bins = 16;
    s.all_axes = false;
    s.sweep_below = 0;
    s.node_cost = 1.0f;
    s.primitive_cost = 3.0f;
    s.max_leaf = 4;
    s.fill_leaves = true;
    s.alpha = 1e-5f;
    s.unsplitting = false;
    return s;
}

SbvhSettings SbvhSettings::quality() { return {}; }

void SbvhSettings::validate() const {
    require<std::uint32_t>("object_bins", object_bins, 2, kMaxBins);
    require<std::uint32_t>("spatial_bins", spatial_bins, 2, kMaxBins);
    require<std::uint32_t>("sweep_below", sweep_below, 0, kMaxBins);
    require("node_cost", node_cost, 1e-6f, 1e6f);
    require("primitive_cost", primitive_cost, 1e-6f, 1e6f);
    require<std::uint32_t>("max_leaf", max_leaf, 1, 255);
    require("alpha", alpha, 0.0f, 1.0f);
    require("reference_budget", reference_budget, 1.0f, 64.0f);
}

}  // namespace ctpbench
