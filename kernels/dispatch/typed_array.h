// The elements of one type in leaf order, and the loop over a leaf of them: no branch on type inside.
#pragma once

#include "layout.h"

namespace ctpbench {

template <class Methods, class T>
struct TypedArray {
    const T* elements;

    CTP_INLINE void intersect_leaf(const BvhNode& leaf, const RayContext<Methods>& ray, Hit& hit) const {
        const T* e = elements + leaf.first;
        const T* end = e + leaf.count();
        do {
            e->intersect(ray, hit);
        } while (++e != end);
    }
};

}  // namespace ctpbench
