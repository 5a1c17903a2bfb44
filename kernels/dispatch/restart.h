// The paper's "kernel restart": a tree per primitive type, traversed by one kernel after another. With
// carry_t the closest t of one pass bounds the next one's search; without it each pass starts afresh and
// the nearer hit is kept.
#pragma once

#include "typed_tree.h"

namespace ctpbench {

template <class Methods, class Types = Primitives<Methods>>
struct Restart {
    static constexpr const char* name = "restart";
    static constexpr TreeKind tree = TreeKind::per_type;

    // A tree for each type.
    template <class Place>
    struct ViewsIn {
        template <class T>
        using ViewOf = TypedTree<Methods, typename Place::template Element<T>>;

        PerType<ViewOf, Types> trees;
    };

    class Layout {
    public:
        explicit Layout(const LayoutInput& in) {
            for_each_type(Types{}, [&](auto tag) {
                using T = typename decltype(tag)::type;
                trees_.template of<T>() = {in.per_type.at(primitive_tag<T>), in.geometry};
            });
        }
        template <class Place>
        ViewsIn<Place> view(const Place& place) const {
            ViewsIn<Place> views;
            for_each_type(Types{}, [&](auto tag) {
                using T = typename decltype(tag)::type;
                views.trees.template of<T>() = trees_.template of<T>().view(place);
            });
            return views;
        }
        std::size_t bytes() const {
            std::size_t total = 0;
            for_each_type(Types{}, [&](auto tag) {
                total += trees_.template of<typename decltype(tag)::type>().bytes();
            });
            return total;
        }

    private:
        template <class T>
        using TreeOf = TypedTreeLayout<Methods, T>;
        PerType<TreeOf, Types> trees_;
    };

    template <class Views, class ForEach>
    static void intersect(const Views& views, const IntersectBuffers& io, bool carry_t, ForEach&& for_each) {
        int last = -1;
        for_each_type(Types{}, [&](auto tag) {
            using T = typename decltype(tag)::type;
            if (views.trees.template of<T>().nodes != nullptr) last = index_of<T, Types>;
        });
        if (last < 0) return for_each(io.count, MissKernel{io});
        bool first = true;
        for_each_type(Types{}, [&](auto tag) {
            using T = typename decltype(tag)::type;
            const auto& view = views.trees.template of<T>();
            using View = std::remove_cvref_t<decltype(view)>;
            if (view.nodes == nullptr) return;
            IntersectBuffers pass = io;
            if (index_of<T, Types> != last) pass.keys = {};  // hits are not final yet
            if (first)
                for_each(io.count, IntersectKernel<Methods, View>{view, pass});
            else
                for_each(io.count, LaterPassKernel<Methods, View>{view, pass, carry_t});
            first = false;
        });
    }
};

}  // namespace ctpbench
