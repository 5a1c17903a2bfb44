// Compile-time polymorphism, the paper's contender: one kernel, materials in an array of variants.
#pragma once

#include "../../variant.h"
#include "sum_type.h"

namespace ctpbench {

template <class Types>
struct ShadeCtp {
    static constexpr const char* name = "ctp";
    static constexpr PathOrder order = PathOrder::as_traced;
    using Element = OneOf<Variant, Types>;

    struct Visit {
        template <class Visitor>
        CTP_INLINE Scattering operator()(Visitor&& visitor, const Element& element) const {
            return apply_visitor(visitor, element);
        }
    };
    using Layout = SumTypeMaterials<Types, Element, Visit>;

    template <class Offset, class View, class ForEach>
    static void shade(const View& view, const ShadeBuffers& io, const ShadeWork& work, ForEach&& for_each) {
        shade_in_one_kernel<Offset>(view, io, work, for_each);
    }
};

}  // namespace ctpbench
