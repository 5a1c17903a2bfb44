// Runtime polymorphism at its best: virtual calls as in `oop`, but the objects of one type are contiguous
// and in the order in which leaves first name them.
#pragma once

#include <limits>
#include <tuple>
#include <vector>

#include "oop.h"

namespace ctpbench {

template <class Methods>
struct OopArena {
    static constexpr const char* name = "oop_arena";
    static constexpr TreeKind tree = TreeKind::mixed;
    using Base = PrimitiveBase<Methods>;

    template <class... Ts>
    using Arenas = std::tuple<Array<PrimitiveObject<Methods, Ts>>...>;

    class Layout {
    public:
        explicit Layout(const LayoutInput& in) : tree_(in.mixed) {
            constexpr auto unplaced = std::numeric_limits<std::uint32_t>::max();
            std::vector<std::uint32_t> place[kPrimitiveTypes];  // in its arena, by scene index
            for_each_type(Primitives<Methods>{}, [&](auto tag) {
                using T = typename decltype(tag)::type;
                place[index_of<T, Primitives<Methods>>].assign(T::count(in.geometry), unplaced);
                arena<T>().reserve(T::count(in.geometry));  // so that addresses stay valid
            });
            elements_.reserve(in.mixed.ref_count);
            for (std::size_t i = 0; i < in.mixed.ref_count; ++i) {
                const PrimitiveRef ref = in.mixed.refs[i];
                visit_type<Primitives<Methods>>(ref.type, [&](auto tag) {
                    using T = typename decltype(tag)::type;
                    std::uint32_t& at = place[ref.type][ref.index];
                    if (at == unplaced) {
                        at = static_cast<std::uint32_t>(arena<T>().size());
                        arena<T>().emplace_back(T::make(in.geometry, ref.index));
                    }
                    elements_.push_back(&arena<T>()[at]);
                });
            }
        }
        // Of the host alone: objects are constructed where their virtual tables are.
        VirtualLeaves<Methods> view(HostPlace) const { return {tree_.nodes, elements_.data()}; }
        std::size_t bytes() const {
            std::size_t total = elements_.size() * sizeof(Base*);
            std::apply([&](const auto&... a) { ((total += a.size() * sizeof(a[0])), ...); }, arenas_);
            return total;
        }

    private:
        template <class T>
        Array<PrimitiveObject<Methods, T>>& arena() {
            return std::get<Array<PrimitiveObject<Methods, T>>>(arenas_);
        }

        TreeView tree_;
        Rebind<Arenas, Primitives<Methods>> arenas_;
        Array<const Base*> elements_;
    };

    template <class View, class ForEach>
    static void intersect(const View& view, const IntersectBuffers& io, bool, ForEach&& for_each) {
        intersect_in_one_pass<Methods>(view, io, for_each);
    }
};

}  // namespace ctpbench
