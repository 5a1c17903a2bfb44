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

    template <class Element>
    struct View {
        const BvhNode* nodes = nullptr;  // null: the scene has none of this type, and needs no pass for it
        TypedArray<Methods, Element> array{};

        CTP_INLINE void closest_hit(const RayContext<Methods>& ray, Hit& hit) const {
            const auto entries = [&](const BvhNode& leaf) -> const void* {
                return array.elements + leaf.first;
            };
            traverse<Methods>(nodes, ray, hit, entries,
                              [&](const BvhNode& leaf) { array.intersect_leaf(leaf, ray, hit); });
        }
    };

    // A view for each type.
    template <class Place>
    struct ViewsIn {
        template <class T>
        using ViewOf = View<typename Place::template Element<T>>;
        template <class... Ts>
        struct Of : ViewOf<Ts>... {};

        Rebind<Of, Primitives<Methods>> all;

        template <class T>
        const ViewOf<T>& of() const {
            return all;
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
                trees_[index_of<T, Primitives<Methods>>] = tree;
                auto& array = std::get<Array<T>>(arrays_);
                array.reserve(tree.ref_count);
                for (std::size_t i = 0; i < tree.ref_count; ++i)
                    array.push_back(T::make(in.geometry, tree.refs[i].index));
            });
        }
        template <class Place>
        ViewsIn<Place> view(const Place& place) const {
            ViewsIn<Place> views;
            for_each_type(Primitives<Methods>{}, [&](auto tag) {
                using T = typename decltype(tag)::type;
                const Array<T>& array = std::get<Array<T>>(arrays_);
                const TreeView& tree = trees_[index_of<T, Primitives<Methods>>];
                if (!array.empty())
                    static_cast<typename ViewsIn<Place>::template ViewOf<T>&>(views.all) = {
                        place(tree.nodes, tree.node_count), {place.elements(array)}};
            });
            return views;
        }
        std::size_t bytes() const {
            std::size_t total = 0;
            std::apply([&](const auto&... a) { ((total += a.size() * sizeof(a[0])), ...); }, arrays_);
            return total;
        }

    private:
        TreeView trees_[kPrimitiveTypes];
        Rebind<Arrays, Primitives<Methods>> arrays_;
    };

    template <class Views, class ForEach>
    static void intersect(const Views& views, const IntersectBuffers& io, bool carry_t, ForEach&& for_each) {
        int last = -1;
        for_each_type(Primitives<Methods>{}, [&](auto tag) {
            using T = typename decltype(tag)::type;
            if (views.template of<T>().nodes != nullptr) last = index_of<T, Primitives<Methods>>;
        });
        bool first = true;
        for_each_type(Primitives<Methods>{}, [&](auto tag) {
            using T = typename decltype(tag)::type;
            const auto& view = views.template of<T>();
            using View = std::remove_cvref_t<decltype(view)>;
            if (view.nodes == nullptr) return;
            IntersectBuffers pass = io;
            if (index_of<T, Primitives<Methods>> != last) pass.keys = {};  // hits are not final yet
            if (first)
                for_each(io.count, IntersectKernel<Methods, View, Pass::first>{view, pass});
            else if (carry_t)
                for_each(io.count, IntersectKernel<Methods, View, Pass::carry>{view, pass});
            else
                for_each(io.count, IntersectKernel<Methods, View, Pass::merge>{view, pass});
            first = false;
        });
    }
};

}  // namespace ctpbench
