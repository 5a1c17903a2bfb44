// The standard library's variant in place of the paper's: what a user who writes no variant gets.
#pragma once

#include <variant>

#include "mixed_leaves.h"

namespace ctpbench {

template <class Methods, class Types = Primitives<Methods>>
struct StdVariant {
    static constexpr const char* name = "std_variant";
    static constexpr TreeKind tree = TreeKind::mixed;
    using Element = OneOf<std::variant, Types>;

    struct Visit {
        CTP_INLINE void operator()(const Element& e, const RayContext<Methods>& ray, Hit& hit) const {
            std::visit([&](const auto& primitive) { primitive.intersect(ray, hit); }, e);
        }
    };
    using Layout = SumTypeLayout<Methods, Types, Element, Visit>;

    template <class View, class ForEach>
    static void intersect(const View& view, const IntersectBuffers& io, bool, ForEach&& for_each) {
        intersect_in_one_pass<Methods>(view, io, for_each);
    }
};

}  // namespace ctpbench
