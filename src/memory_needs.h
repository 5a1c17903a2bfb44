// Whether a run will fit into memory, before it starts: what is asked for may be a typing error away from
// what a machine has.
#pragma once

#include <cstdint>
#include <vector>

#include "config/cells.h"

namespace ctpbench {

// Throws Error(usage) with the number of bytes for the first workload that needs more than are free. Of
// spheres and pixels alone: how large a mesh is shows when it is loaded.
void require_memory_for(const std::vector<Cell>& cells, const Config& config);

// The same of one picture.
void require_memory_for_picture(std::uint32_t width, std::uint32_t height, std::uint32_t spheres);

}  // namespace ctpbench
