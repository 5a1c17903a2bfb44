// Runtime polymorphism: one tree whose leaves hold base-class pointers, tested by virtual calls. Each
// object is a heap allocation of its own, made in scene order, as a class hierarchy's user has them.
#pragma once

#include <memory>
#include <vector>

#include "../oop.h"
#include "mixed_leaves.h"
#include "object_order.h"

namespace ctpbench {

template <class Methods>
struct VirtualVisit {
    CTP_INLINE void operator()(const PrimitiveBase<Methods>* e, const RayContext<Methods>& ray,
                               Hit& hit) const {
        e->intersect(ray, hit);
    }
};

template <class Methods>
using VirtualLeaves = MixedLeaves<Methods, const PrimitiveBase<Methods>*, VirtualVisit<Methods>>;

template <class Methods, class Types = Primitives<Methods>>
struct Oop {
    static constexpr const char* name = "oop";
    static constexpr TreeKind tree = TreeKind::mixed;
    using Base = PrimitiveBase<Methods>;

    class Layout {
    public:
        explicit Layout(const LayoutInput& in) : tree_(in.mixed) {
            const ObjectPlaces places = place_objects<Types>(in.mixed, ObjectOrder::scene);
            std::size_t first[Types::size];
            for_each_type(Types{}, [&](auto tag) {
                using T = typename decltype(tag)::type;
                using Object = PrimitiveObject<Methods, T>;
                first[index_of<T, Types>] = objects_.size();
                for (const std::uint32_t i : places.primitives[index_of<T, Types>])
                    objects_.push_back(std::make_unique<Object>(T::make(in.geometry, i)));
                bytes_ += places.primitives[index_of<T, Types>].size() * sizeof(Object);
            });
            elements_.reserve(places.entries.size());
            for (const PrimitiveRef& entry : places.entries)
                elements_.push_back(objects_[first[entry.type] + entry.index].get());
        }
        // Of the host alone: objects are constructed where their virtual tables are.
        VirtualLeaves<Methods> view(HostPlace) const { return {tree_.nodes, elements_.data()}; }
        std::size_t bytes() const { return bytes_ + elements_.size() * sizeof(Base*); }

    private:
        TreeView tree_;
        std::vector<std::unique_ptr<Base>> objects_;
        Array<const Base*> elements_;
        std::size_t bytes_ = 0;
    };

    template <class View, class ForEach>
    static void intersect(const View& view, const IntersectBuffers& io, bool, ForEach&& for_each) {
        intersect_in_one_pass<Methods>(view, io, for_each);
    }
};

}  // namespace ctpbench
