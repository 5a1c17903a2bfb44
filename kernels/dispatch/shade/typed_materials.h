// An array for each material type, without tags or padding: what strategies with a kernel per type lay out.
#pragma once

#include "layout.h"

namespace ctpbench {

template <class Types>
class TypedMaterialArrays {
public:
    using View = PerType<TypedMaterials, Types>;

    explicit TypedMaterialArrays(const MaterialInput& in) : in_(in) {
        in.for_each<Types>([&](const auto& material) {
            arrays_.template of<std::remove_cvref_t<decltype(material)>>().push_back(material);
        });
    }
    template <class Place>
    View view(const Place& place) const {
        View view{};
        for_each_type(Types{}, [&](auto tag) {
            using T = typename decltype(tag)::type;
            const Array<T>& array = arrays_.template of<T>();
            view.template of<T>() = {place(array.data(), array.size()), in_.begin<T, Types>()};
        });
        return view;
    }

private:
    MaterialInput in_;
    PerType<Array, Types> arrays_;
};

}  // namespace ctpbench
