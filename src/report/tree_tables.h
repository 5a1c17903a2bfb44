// The paper's Table 2, made from the trees of a run: what spheres among the triangles do to their number of
// nodes.
#pragma once

#include <string>

#include "measure/results.h"

namespace ctpbench {

// Rows are sphere counts, columns are scenes: nodes of the combined trees, and of each type's own.
std::string table2_csv(const Results& results);

// Table 2 for people: thousands of nodes, ours beside the paper's, and how far each grows by its spheres.
std::string table2_markdown(const Results& results);

}  // namespace ctpbench
