// The names of the types of a list (kernels/type_list.h), in its order.
#pragma once

#include <string>
#include <vector>

#include "kernels/type_list.h"

namespace ctpbench {

// Those at positions whose bit in the mask is set.
template <class List>
std::vector<std::string> names_of(std::uint32_t mask = ~0u) {
    static_assert(List::size <= 32, "a type has a bit in the mask");
    std::vector<std::string> names;
    std::uint32_t position = 0;
    for_each_type(List{}, [&](auto tag) {
        if (mask >> position++ & 1u) names.emplace_back(decltype(tag)::type::name);
    });
    return names;
}

}  // namespace ctpbench
