// Runtime polymorphism as in `oop`, but the objects of one type are contiguous.
#pragma once

#include <tuple>

#include "oop.h"

namespace ctpbench {

struct ShadeOopArena {
    static constexpr const char* name = "oop_arena";
    static constexpr PathOrder order = PathOrder::as_traced;

    template <class... Ts>
    using Arenas = std::tuple<Array<MaterialObject<Ts>>...>;

    class Layout {
    public:
        explicit Layout(const MaterialInput& in) {
            for_each_type(Materials{}, [&](auto tag) {  // so that addresses stay valid
                using T = typename decltype(tag)::type;
                arena<T>().reserve(in.first[material_type<T> + 1] - in.first[material_type<T>]);
            });
            in.for_each([&](const auto& material) {
                using T = std::remove_cvref_t<decltype(material)>;
                pointers_.push_back(&arena<T>().emplace_back(material));
            });
        }
        // Of the host alone: objects are constructed where their virtual tables are.
        VirtualMaterials view(HostPlace) const { return {pointers_.data()}; }

    private:
        template <class T>
        Array<MaterialObject<T>>& arena() {
            return std::get<Array<MaterialObject<T>>>(arenas_);
        }

        Rebind<Arenas, Materials> arenas_;
        Array<const MaterialBase*> pointers_;
    };

    template <class Offset, class View, class ForEach>
    static void shade(const View& view, const ShadeBuffers& io, const ShadeWork& work, ForEach&& for_each) {
        shade_in_one_kernel<Offset>(view, io, work, for_each);
    }
};

}  // namespace ctpbench
