// Runtime polymorphism at its best: virtual calls as in `oop`, but the objects of one type are contiguous
// and in the order in which leaves first name them.
#pragma once

#include <vector>

#include "oop.h"

namespace ctpbench {

template <class Methods, class Types = Primitives<Methods>>
struct OopArena {
    static constexpr const char* name = "oop_arena";
    static constexpr TreeKind tree = TreeKind::mixed;
    using Base = PrimitiveBase<Methods>;

    template <class T>
    using Arena = Array<PrimitiveObject<Methods, T>>;

    class Layout {
    public:
        explicit Layout(const LayoutInput& in) : tree_(in.mixed) {
            const ObjectPlaces places = place_objects<Types>(in.mixed, ObjectOrder::leaves);
            for_each_type(Types{}, [&](auto tag) {
                using T = typename decltype(tag)::type;
                const std::vector<std::uint32_t>& of_type = places.primitives[index_of<T, Types>];
                auto& arena = arenas_.template of<T>();
                arena.reserve(of_type.size());  // so that addresses stay valid
                for (const std::uint32_t i : of_type) arena.emplace_back(T::make(in.geometry, i));
            });
            elements_.reserve(places.entries.size());
            for (const PrimitiveRef& entry : places.entries)
                visit_type<Types>(entry.type, [&](auto tag) {
                    elements_.push_back(&arenas_.template of<typename decltype(tag)::type>()[entry.index]);
                });
        }
        // Of the host alone: objects are constructed where their virtual tables are.
        VirtualLeaves<Methods> view(HostPlace) const { return {tree_.nodes, elements_.data()}; }
        std::size_t bytes() const {
            std::size_t total = elements_.size() * sizeof(Base*);
            for_each_type(Types{}, [&](auto tag) {
                using T = typename decltype(tag)::type;
                total += arenas_.template of<T>().size() * sizeof(PrimitiveObject<Methods, T>);
            });
            return total;
        }

    private:
        TreeView tree_;
        PerType<Arena, Types> arenas_;
        Array<const Base*> elements_;
    };

    template <class View, class ForEach>
    static void intersect(const View& view, const IntersectBuffers& io, bool, ForEach&& for_each) {
        intersect_in_one_pass<Methods>(view, io, for_each);
    }
};

}  // namespace ctpbench
