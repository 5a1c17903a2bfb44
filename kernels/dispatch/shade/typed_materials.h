// An array for each material type, without tags or padding: what strategies with a kernel per type lay out.
#pragma once

#include <tuple>

#include "layout.h"

namespace ctpbench {

class TypedMaterialArrays {
public:
    template <class... Ts>
    struct ViewOf : TypedMaterials<Ts>... {
        template <class T>
        CTP_INLINE const TypedMaterials<T>& of() const {
            return *this;
        }
    };
    using View = Rebind<ViewOf, Materials>;

    explicit TypedMaterialArrays(const MaterialInput& in) : in_(in) {
        in.for_each([&](const auto& material) {
            std::get<Array<std::remove_cvref_t<decltype(material)>>>(arrays_).push_back(material);
        });
    }
    template <class Place>
    View view(const Place& place) const {
        View view{};
        for_each_type(Materials{}, [&](auto tag) {
            using T = typename decltype(tag)::type;
            const Array<T>& array = std::get<Array<T>>(arrays_);
            static_cast<TypedMaterials<T>&>(view) = {place(array.data(), array.size()),
                                                     in_.first[material_type<T>]};
        });
        return view;
    }

private:
    template <class... Ts>
    using Arrays = std::tuple<Array<Ts>...>;

    MaterialInput in_;
    Rebind<Arrays, Materials> arrays_;
};

}  // namespace ctpbench
