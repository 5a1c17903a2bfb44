// Seconds as a reader takes them in.
#pragma once

#include <string>

namespace ctpbench {

// `1:02:03`, `2:03`
std::string duration(double seconds);

}  // namespace ctpbench
