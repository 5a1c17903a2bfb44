// Help for a mistyped name: the known name that is nearest to it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ctpbench {

// The known name fewest edits away (insert, delete, replace, swap neighbours; letter case is ignored), or
// nothing when even that one shares too little with `name` to be what was meant.
std::optional<std::string> nearest_name(std::string_view name, const std::vector<std::string>& known);

// `unknown strategy "cpt"; did you mean "ctp"? choices: "ctp", "oop"`
std::string unknown_name(std::string_view what, std::string_view name, const std::vector<std::string>& known);

}  // namespace ctpbench
