// Compile-time polymorphism, the paper's contender: one tree over an array of variants.
#pragma once

#include "../variant.h"
#include "mixed_leaves.h"

namespace ctpbench {

template <class Methods, class Types = Primitives<Methods>>
struct Ctp {
    static constexpr const char* name = "ctp";
    static constexpr TreeKind tree = TreeKind::mixed;
    using Element = OneOf<Variant, Types>;

    struct Visit {
        CTP_INLINE void operator()(const Element& e, const RayContext<Methods>& ray, Hit& hit) const {
            apply_visitor([&](const auto& primitive) { primitive.intersect(ray, hit); }, e);
        }
    };
    using Layout = SumTypeLayout<Methods, Types, Element, Visit>;

    template <class View, class ForEach>
    static void intersect(const View& view, const IntersectBuffers& io, bool, ForEach&& for_each) {
        intersect_in_one_pass<Methods>(view, io, for_each);
    }
};

}  // namespace ctpbench
