// Runtime polymorphism as in `oop`, but the objects of one type are contiguous.
#pragma once

#include "oop.h"

namespace ctpbench {

template <class Types>
struct ShadeOopArena {
    static constexpr const char* name = "oop_arena";
    static constexpr PathOrder order = PathOrder::as_traced;

    template <class T>
    using Arena = Array<MaterialObject<T>>;

    class Layout {
    public:
        explicit Layout(const MaterialInput& in) {
            for_each_type(Types{}, [&](auto tag) {  // so that addresses stay valid
                using T = typename decltype(tag)::type;
                arenas_.template of<T>().reserve(in.end<T, Types>() - in.begin<T, Types>());
            });
            in.for_each<Types>([&](const auto& material) {
                using T = std::remove_cvref_t<decltype(material)>;
                pointers_.push_back(&arenas_.template of<T>().emplace_back(material));
            });
        }
        // Of the host alone: objects are constructed where their virtual tables are.
        VirtualMaterials view(HostPlace) const { return {pointers_.data()}; }

    private:
        PerType<Arena, Types> arenas_;
        Array<const MaterialBase*> pointers_;
    };

    template <class Offset, class View, class ForEach>
    static void shade(const View& view, const ShadeBuffers& io, const ShadeWork& work, ForEach&& for_each) {
        shade_in_one_kernel<Offset>(view, io, work, for_each);
    }
};

}  // namespace ctpbench
