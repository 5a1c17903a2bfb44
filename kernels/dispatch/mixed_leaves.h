// One tree whose leaves mix types: the traversal that variants and virtual calls share. They differ in
// what an element is and in how it finds its type's test, which is all that the suite compares here.
#pragma once

#include "../traverse.h"
#include "layout.h"
#include "typed_tree.h"

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
// elements are contiguous.
template <class Methods, class Types, class Element, class Visit>
class MixedLeavesLayout {
public:
    explicit MixedLeavesLayout(const LayoutInput& in) : tree_(in.mixed) {
        elements_.reserve(tree_.ref_count);
        for (std::size_t i = 0; i < tree_.ref_count; ++i) {
            const PrimitiveRef ref = tree_.refs[i];
            visit_by_tag<Types>(ref.type, [&](auto type) {
                elements_.push_back(Element(decltype(type)::type::make(in.geometry, ref.index)));
            });
        }
    }

    template <class Place>
    MixedLeaves<Methods, typename Place::template Element<Element>, Visit> view(const Place& place) const {
        return {place(tree_.nodes, tree_.node_count), place.elements(elements_)};
    }
    std::size_t bytes() const { return elements_.size() * sizeof(Element); }

private:
    TreeView tree_;
    Array<Element> elements_;
};

// The layout of a strategy that stores primitives by value in a sum type, of which one type has no need.
template <class Methods, class Types, class Element, class Visit>
using SumTypeLayout = std::conditional_t<Types::size == 1, OneTypeLayout<Methods, Types, &LayoutInput::mixed>,
                                         MixedLeavesLayout<Methods, Types, Element, Visit>>;

}  // namespace ctpbench
