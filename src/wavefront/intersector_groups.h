// The explicit instantiations of intersectors on CPU threads, in groups that are compiled apart
// (intersectors/). A group without its file does not link.
#pragma once

#include "kernels/methods/exchanges.h"
#include "wavefront/intersector.h"

namespace ctpbench {

// Every strategy with one bundle; null if the strategy is none of the registry.
template <class Bundle>
std::unique_ptr<Intersector> make_with_bundle(std::string_view strategy, const LayoutInput& input);

// Strategy `ctp` with a list of combinations; null if the key is none of theirs. The bundles' own tests are
// left out: they are the bundle's.
template <class List>
std::unique_ptr<Intersector> make_with_tests(std::string_view key, const LayoutInput& input);

// Every strategy with the default methods and synthetic types; null if the strategy is none of the registry.
std::unique_ptr<Intersector> make_synthetic(std::string_view strategy, const LayoutInput& input);

}  // namespace ctpbench
