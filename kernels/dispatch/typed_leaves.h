// One tree in which a leaf holds one type, named in the leaf word: one branch per leaf rather than per
// primitive, and each type in an array of its own, without tags or padding.
#pragma once

#include <tuple>
#include <vector>

#include "../array.h"
#include "../traverse.h"
#include "typed_array.h"

namespace ctpbench {

template <class Methods>
struct TypedLeaves {
    static constexpr const char* name = "typed_leaves";
    static constexpr TreeKind tree = TreeKind::typed_leaves;

    template <class Place>
    struct ViewIn {
        template <class T>
        using Elements = TypedArray<Methods, typename Place::template Element<T>>;
        template <class... Ts>
        struct ArraysOf : Elements<Ts>... {};

        const BvhNode* nodes;  // a leaf's `first` counts in its type's array
        Rebind<ArraysOf, Primitives<Methods>> arrays;

        CTP_INLINE void closest_hit(const RayContext<Methods>& ray, Hit& hit) const {
            const auto entries = [&](const BvhNode& leaf) {
                // Selected without a branch: it is only an address to fetch from.
                const void* first = nodes;
                for_each_type(Primitives<Methods>{}, [&](auto tag) {
                    using T = typename decltype(tag)::type;
                    const auto* element = static_cast<const Elements<T>&>(arrays).elements + leaf.first;
                    first = leaf.type() == index_of<T, Primitives<Methods>> ? element : first;
                });
                return first;
            };
            traverse<Methods>(nodes, ray, hit, entries, [&](const BvhNode& leaf) {
                visit_type<Primitives<Methods>>(leaf.type(), [&](auto tag) {
                    using T = typename decltype(tag)::type;
                    static_cast<const Elements<T>&>(arrays).intersect_leaf(leaf, ray, hit);
                });
            });
        }
    };

    template <class... Ts>
    using Vectors = std::tuple<Array<Ts>...>;

    class Layout {
    public:
        explicit Layout(const LayoutInput& in)
            : nodes_(in.typed_leaves.nodes, in.typed_leaves.nodes + in.typed_leaves.node_count) {
            // Leaves are rewritten in the order of their references, so each type's array is in leaf order.
            std::vector<std::uint32_t> place(in.typed_leaves.ref_count);
            std::size_t counts[kPrimitiveTypes] = {};
            for (std::size_t i = 0; i < in.typed_leaves.ref_count; ++i)
                ++counts[in.typed_leaves.refs[i].type];
            for_each_type(Primitives<Methods>{}, [&](auto tag) {
                using T = typename decltype(tag)::type;
                std::get<Array<T>>(vectors_).reserve(counts[index_of<T, Primitives<Methods>>]);
            });
            for (std::size_t i = 0; i < in.typed_leaves.ref_count; ++i) {
                const PrimitiveRef ref = in.typed_leaves.refs[i];
                visit_type<Primitives<Methods>>(ref.type, [&](auto tag) {
                    using T = typename decltype(tag)::type;
                    auto& elements = std::get<Array<T>>(vectors_);
                    place[i] = static_cast<std::uint32_t>(elements.size());
                    elements.push_back(T::make(in.geometry, ref.index));
                });
            }
            for (BvhNode& node : nodes_)
                if (node.is_leaf()) node.first = place[node.first];
        }
        template <class Place>
        ViewIn<Place> view(const Place& place) const {
            ViewIn<Place> view{place(nodes_.data(), nodes_.size()), {}};
            for_each_type(Primitives<Methods>{}, [&](auto tag) {
                using T = typename decltype(tag)::type;
                static_cast<typename ViewIn<Place>::template Elements<T>&>(view.arrays).elements =
                    place.elements(std::get<Array<T>>(vectors_));
            });
            return view;
        }
        std::size_t bytes() const {
            std::size_t total = nodes_.size() * sizeof(BvhNode);
            std::apply([&](const auto&... v) { ((total += v.size() * sizeof(v[0])), ...); }, vectors_);
            return total;
        }

    private:
        NodeArray nodes_;
        Rebind<Vectors, Primitives<Methods>> vectors_;
    };

    template <class View, class ForEach>
    static void intersect(const View& view, const IntersectBuffers& io, bool, ForEach&& for_each) {
        intersect_in_one_pass<Methods>(view, io, for_each);
    }
};

}  // namespace ctpbench
