// One tree in which a leaf holds one type, named in the leaf word: one branch per leaf rather than per
// primitive, and each type in an array of its own, without tags or padding.
#pragma once

#include <array>
#include <vector>

#include "../array.h"
#include "typed_tree.h"

namespace ctpbench {

template <class Methods, class Types = Primitives<Methods>>
struct TypedLeaves {
    static constexpr const char* name = "typed_leaves";
    static constexpr TreeKind tree = TreeKind::typed_leaves;

    // Whether an address to fetch ahead from is selected by arithmetic, which is faster for a few types.
    static constexpr bool kSelected = Types::size <= 4;

    template <class Place>
    struct ViewIn {
        template <class T>
        using Elements = TypedArray<Methods, typename Place::template Element<T>>;

        // A leaf's type counts among Types, and its `first` in its type's array.
        const BvhNode* nodes;
        PerType<Elements, Types> arrays;
        const std::byte* first_elements[kSelected ? 1 : Types::size];  // by type, if that is looked up

        CTP_INLINE void closest_hit(const RayContext<Methods>& ray, Hit& hit) const {
            const auto entries = [&](const BvhNode& leaf) { return first_entry(leaf); };
            traverse<Methods>(nodes, ray, hit, entries, [&](const BvhNode& leaf) {
                visit_type<Types>(leaf.type(), [&](auto tag) {
                    using T = typename decltype(tag)::type;
                    arrays.template of<T>().intersect_leaf(leaf, ray, hit);
                });
            });
        }

    private:
        template <class... Ts>
        CTP_INLINE static std::uint32_t size_of(TypeList<Ts...>, std::uint32_t type) {
            static constexpr std::uint32_t sizes[] = {sizeof(typename Place::template Element<Ts>)...};
            return sizes[type];
        }
        CTP_INLINE const void* first_entry(const BvhNode& leaf) const {
            if constexpr (!kSelected)
                return first_elements[leaf.type()] + std::size_t{leaf.first} * size_of(Types{}, leaf.type());
            // Sums of integers: this is asked of every array, also of those that the leaf has no element in.
            std::uintptr_t first = 0;
            for_each_type(Types{}, [&](auto tag) {
                using T = typename decltype(tag)::type;
                const auto* elements = arrays.template of<T>().elements;
                const std::uintptr_t element =
                    reinterpret_cast<std::uintptr_t>(elements) + std::size_t{leaf.first} * sizeof *elements;
                first = leaf.type() == index_of<T, Types> ? element : first;
            });
            return reinterpret_cast<const void*>(first);
        }
    };

    class SeveralTypes {
    public:
        explicit SeveralTypes(const LayoutInput& in)
            : nodes_(in.typed_leaves.nodes, in.typed_leaves.nodes + in.typed_leaves.node_count) {
            std::array<std::size_t, kLeafTypes> counts{};
            for (std::size_t i = 0; i < in.typed_leaves.ref_count; ++i)
                ++counts[in.typed_leaves.refs[i].type];
            for_each_type(Types{}, [&](auto tag) {
                using T = typename decltype(tag)::type;
                vectors_.template of<T>().reserve(counts[primitive_tag<T>]);
            });
            // Leaves are rewritten in the order of their references, so each type's array is in leaf order.
            std::vector<std::uint32_t> place(in.typed_leaves.ref_count);
            for (std::size_t i = 0; i < in.typed_leaves.ref_count; ++i) {
                const PrimitiveRef ref = in.typed_leaves.refs[i];
                visit_by_tag<Types>(ref.type, [&](auto tag) {
                    using T = typename decltype(tag)::type;
                    auto& elements = vectors_.template of<T>();
                    place[i] = static_cast<std::uint32_t>(elements.size());
                    elements.push_back(T::make(in.geometry, ref.index));
                });
            }
            for (BvhNode& node : nodes_)
                if (node.is_leaf()) {
                    visit_by_tag<Types>(node.type(), [&](auto tag) {
                        using T = typename decltype(tag)::type;
                        node.leaf = BvhNode::leaf_word(index_of<T, Types>, node.count());
                    });
                    node.first = place[node.first];
                }
        }
        template <class Place>
        ViewIn<Place> view(const Place& place) const {
            ViewIn<Place> view{place(nodes_.data(), nodes_.size()), {}, {}};
            for_each_type(Types{}, [&](auto tag) {
                using T = typename decltype(tag)::type;
                const auto* elements = place.elements(vectors_.template of<T>());
                view.arrays.template of<T>().elements = elements;
                if constexpr (!kSelected)
                    view.first_elements[index_of<T, Types>] = reinterpret_cast<const std::byte*>(elements);
            });
            return view;
        }
        std::size_t bytes() const {
            std::size_t total = nodes_.size() * sizeof(BvhNode);
            for_each_type(Types{}, [&](auto tag) {
                using T = typename decltype(tag)::type;
                total += vectors_.template of<T>().size() * sizeof(T);
            });
            return total;
        }

    private:
        NodeArray nodes_;
        PerType<Array, Types> vectors_;
    };

    using Layout =
        std::conditional_t<Types::size == 1, OneTypeLayout<Methods, Types, &LayoutInput::typed_leaves>,
                           SeveralTypes>;

    template <class View, class ForEach>
    static void intersect(const View& view, const IntersectBuffers& io, bool, ForEach&& for_each) {
        intersect_in_one_pass<Methods>(view, io, for_each);
    }
};

}  // namespace ctpbench
