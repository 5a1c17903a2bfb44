// One tree whose leaves mix types: the traversal that variants and virtual calls share. They differ in
// what an element is and in how it finds its type's test, which is all that the suite compares here.
#pragma once

#include "../traverse.h"
#include "layout.h"

namespace ctpbench {

// Visit{}(element, ray, hit) runs the test of one element. Elements are in leaf order.
template <class Methods, class Element, class Visit>
struct MixedLeaves {
    const BvhNode* nodes;
    const Element* elements;

    CTP_INLINE void closest_hit(const RayContext<Methods>& ray, Hit& hit) const {
        const auto entries = [&](const BvhNode& leaf) -> const void* { return elements + leaf.first; };
        traverse<Methods>(nodes, ray, hit, entries, [&](const BvhNode& leaf) {
            const Element* e = elements + leaf.first;
            const Element* end = e + leaf.count();
            do {
                Visit{}(fetch(*e), ray, hit);
            } while (++e != end);
        });
    }
};

// One element per leaf entry: a spatially split primitive is stored once per reference, so that a leaf's
// elements are contiguous. `make(value)` turns a primitive into an element.
template <class Methods, class Element, class Make>
Array<Element> elements_in_leaf_order(const TreeView& tree, const GeometryView& geometry, Make&& make) {
    Array<Element> elements;
    elements.reserve(tree.ref_count);
    for (std::size_t i = 0; i < tree.ref_count; ++i) {
        const PrimitiveRef ref = tree.refs[i];
        visit_type<Primitives<Methods>>(ref.type, [&](auto type) {
            elements.push_back(make(decltype(type)::type::make(geometry, ref.index)));
        });
    }
    return elements;
}

// The layout of a strategy that stores primitives by value in a sum type.
template <class Methods, class Element, class Visit>
class SumTypeLayout {
public:
    explicit SumTypeLayout(const LayoutInput& in)
        : tree_(in.mixed),
          elements_(elements_in_leaf_order<Methods, Element>(
              in.mixed, in.geometry, [](const auto& primitive) { return Element(primitive); })) {}

    template <class Place>
    MixedLeaves<Methods, typename Place::template Element<Element>, Visit> view(const Place& place) const {
        return {place(tree_.nodes, tree_.node_count), place.elements(elements_)};
    }
    std::size_t bytes() const { return elements_.size() * sizeof(Element); }

private:
    TreeView tree_;
    Array<Element> elements_;
};

}  // namespace ctpbench
