// What the user should know but need not act on: printed when a scene is loaded, and recorded with its
// results.
#pragma once

#include <string>
#include <vector>

namespace ctpbench {

using Notices = std::vector<std::string>;

}  // namespace ctpbench
