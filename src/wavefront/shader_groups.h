// The explicit instantiations of shaders on CPU threads, in groups that are compiled apart (shaders/). A
// group without its file does not link.
#pragma once

#include "kernels/methods/lists.h"
#include "wavefront/shader.h"

namespace ctpbench {

// Every strategy with one offset; null if the strategy is none of the registry.
template <class Offset>
std::unique_ptr<Shader> make_with_offset(std::string_view strategy, const MaterialTable& materials);

// Every strategy with the default offset and synthetic types; likewise.
std::unique_ptr<Shader> make_synthetic(std::string_view strategy, const MaterialTable& materials);

}  // namespace ctpbench
