// The elements of one type in leaf order, and the loop over a leaf of them: no branch on type inside.
#pragma once

#include "layout.h"

namespace ctpbench {

template <class Methods, class Element>
struct TypedArray {
    const Element* elements;

    CTP_INLINE void intersect_leaf(const BvhNode& leaf, const RayContext<Methods>& ray, Hit& hit) const {
        const Element* e = elements + leaf.first;
        const Element* end = e + leaf.count();
        do {
            fetch(*e).intersect(ray, hit);
        } while (++e != end);
    }
};

}  // namespace ctpbench
