// The paper's "kernel restart": a tree per primitive type, traversed by one kernel after another. With
// carry_t the closest t of one pass bounds the next one's search; without it each pass starts afresh and
// the nearer hit is kept.
#pragma once

#include <tuple>

#include "../traverse.h"
#include "typed_array.h"

namespace ctpbench {

template <class Methods>
struct Restart {
    static constexpr const char* name = "restart";
    static constexpr TreeKind tree = TreeKind::per_type;

    template <class T>
    struct View {
        const BvhNode* nodes;
        TypedArray<Methods, T> array;

        CTP_INLINE void closest_hit(const RayContext<Methods>& ray, Hit& hit) const {
            const auto entries = [&](const BvhNode& leaf) -> const void* {
                return array.elements + leaf.first;
            };
            traverse<Methods>(nodes, ray, hit, entries,
                              [&](const BvhNode& leaf) { array.intersect_leaf(leaf, ray, hit); });
        }
    };

    template <class... Ts>
    using Arrays = std::tuple<Array<Ts>...>;

    class Layout {
    public:
        explicit Layout(const LayoutInput& in) {
            for_each_type(Primitives<Methods>{}, [&](auto tag) {
                using T = typename decltype(tag)::type;
                const TreeView& tree = in.per_type[index_of<T, Primitives<Methods>>];
                nodes_[index_of<T, Primitives<Methods>>] = tree.nodes;
                auto& array = std::get<Array<T>>(arrays_);
                array.reserve(tree.ref_count);
                for (std::size_t i = 0; i < tree.ref_count; ++i)
                    array.push_back(T::make(in.geometry, tree.refs[i].index));
            });
        }
        template <class T>
        View<T> view() const {
            return {nodes_[index_of<T, Primitives<Methods>>], {std::get<Array<T>>(arrays_).data()}};
        }
        // A type that the scene lacks has no tree and needs no pass.
        template <class T>
        bool has() const {
            return !std::get<Array<T>>(arrays_).empty();
        }
        std::size_t bytes() const {
            std::size_t total = 0;
            std::apply([&](const auto&... a) { ((total += a.size() * sizeof(a[0])), ...); }, arrays_);
            return total;
        }

    private:
        const BvhNode* nodes_[kPrimitiveTypes];
        Rebind<Arrays, Primitives<Methods>> arrays_;
    };

    template <class ForEach>
    static void intersect(const Layout& layout, const IntersectBuffers& io, bool carry_t,
                          ForEach&& for_each) {
        int last = -1;
        for_each_type(Primitives<Methods>{}, [&](auto tag) {
            using T = typename decltype(tag)::type;
            if (layout.template has<T>()) last = index_of<T, Primitives<Methods>>;
        });
        bool first = true;
        for_each_type(Primitives<Methods>{}, [&](auto tag) {
            using T = typename decltype(tag)::type;
            if (!layout.template has<T>()) return;
            const View<T> view = layout.template view<T>();
            IntersectBuffers pass = io;
            if (index_of<T, Primitives<Methods>> != last) pass.keys = {};  // hits are not final yet
            if (first)
                for_each(io.count, IntersectKernel<Methods, View<T>, Pass::first>{view, pass});
            else if (carry_t)
                for_each(io.count, IntersectKernel<Methods, View<T>, Pass::carry>{view, pass});
            else
                for_each(io.count, IntersectKernel<Methods, View<T>, Pass::merge>{view, pass});
            first = false;
        });
    }
};

}  // namespace ctpbench
