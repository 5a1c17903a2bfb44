// Materials by value in an array of sum types: what the variant strategies share. They differ in what an
// element is and in how it is visited. One type has no need of either.
#pragma once

#include <type_traits>

#include "layout.h"

namespace ctpbench {

// The element is of the one type that there is.
struct VisitOnlyType {
    template <class Visitor, class T>
    CTP_INLINE Scattering operator()(Visitor&& visitor, const T& material) const {
        return visitor(material);
    }
};

// Visit{}(visitor, element) calls the visitor with the material that the element holds.
template <class Element, class Visit>
struct SumTypeTable {
    const Element* elements;

    CTP_INLINE Scattering sample(MaterialWord word, const SurfacePoint& point,
                                 const PathRandom& random) const {
        return Visit{}([&](const auto& material) { return material.sample(point, random); },
                       elements[word.number()]);
    }
};

template <class Types, class Element, class Visit>
class SumTypeMaterials {
public:
    using Table = SumTypeTable<Element, std::conditional_t<Types::size == 1, VisitOnlyType, Visit>>;

    explicit SumTypeMaterials(const MaterialInput& in) {
        in.for_each<Types>([&](const auto& material) { elements_.push_back(Element(material)); });
    }
    template <class Place>
    Table view(const Place& place) const {
        return {place(elements_.data(), elements_.size())};
    }

private:
    Array<Element> elements_;
};

}  // namespace ctpbench
