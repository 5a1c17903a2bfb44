// A tree over one type: no tag, no branch on type, no padding. Strategies with a tree per type have several;
// any strategy has just this where there is only one type to branch on.
#pragma once

#include "../traverse.h"
#include "typed_array.h"

namespace ctpbench {

template <class Methods, class Element>
struct TypedTree {
    const BvhNode* nodes = nullptr;  // null: there is none of this type
    TypedArray<Methods, Element> array{};

    CTP_INLINE void closest_hit(const RayContext<Methods>& ray, Hit& hit) const {
        const auto entries = [&](const BvhNode& leaf) -> const void* { return array.elements + leaf.first; };
        traverse<Methods>(nodes, ray, hit, entries,
                          [&](const BvhNode& leaf) { array.intersect_leaf(leaf, ray, hit); });
    }
};

template <class Methods, class T>
class TypedTreeLayout {
public:
    TypedTreeLayout() = default;
    TypedTreeLayout(const TreeView& tree, const GeometryView& geometry) : tree_(tree) {
        elements_.reserve(tree.ref_count);
        for (std::size_t i = 0; i < tree.ref_count; ++i)
            elements_.push_back(T::make(geometry, tree.refs[i].index));
    }
    template <class Place>
    TypedTree<Methods, typename Place::template Element<T>> view(const Place& place) const {
        if (elements_.empty()) return {};
        return {place(tree_.nodes, tree_.node_count), {place.elements(elements_)}};
    }
    std::size_t bytes() const { return elements_.size() * sizeof(T); }

private:
    TreeView tree_;
    Array<T> elements_;
};

// The layout of a strategy with one tree, that member of LayoutInput, where Types holds one type.
template <class Methods, class Types, TreeView LayoutInput::*tree>
class OneTypeLayout : public TypedTreeLayout<Methods, First<Types>> {
public:
    explicit OneTypeLayout(const LayoutInput& in)
        : TypedTreeLayout<Methods, First<Types>>(in.*tree, in.geometry) {}
};

}  // namespace ctpbench
