// Materials by value in an array of sum types: what the variant strategies share. They differ in what an
// element is and in how it is visited.
#pragma once

#include "layout.h"

namespace ctpbench {

// Visit{}(visitor, element) calls the visitor with the material that the element holds.
template <class Element, class Visit>
class SumTypeMaterials {
public:
    struct Table {
        const Element* elements;

        CTP_INLINE Scattering sample(MaterialWord word, const SurfacePoint& point,
                                     const PathRandom& random) const {
            return Visit{}([&](const auto& material) { return material.sample(point, random); },
                           elements[word.number()]);
        }
    };

    explicit SumTypeMaterials(const MaterialInput& in) {
        in.for_each([&](const auto& material) { elements_.push_back(Element(material)); });
    }
    template <class Place>
    Table view(const Place& place) const {
        return {place(elements_.data(), elements_.size())};
    }

private:
    Array<Element> elements_;
};

}  // namespace ctpbench
