// The standard library's variant in place of the paper's.
#pragma once

#include <variant>

#include "sum_type.h"

namespace ctpbench {

template <class Types>
struct ShadeStdVariant {
    static constexpr const char* name = "std_variant";
    static constexpr PathOrder order = PathOrder::as_traced;
    using Element = OneOf<std::variant, Types>;

    struct Visit {
        template <class Visitor>
        CTP_INLINE Scattering operator()(Visitor&& visitor, const Element& element) const {
            return std::visit(visitor, element);
        }
    };
    using Layout = SumTypeMaterials<Types, Element, Visit>;

    template <class Offset, class View, class ForEach>
    static void shade(const View& view, const ShadeBuffers& io, const ShadeWork& work, ForEach&& for_each) {
        shade_in_one_kernel<Offset>(view, io, work, for_each);
    }
};

}  // namespace ctpbench
