// Runtime polymorphism: one kernel, materials behind base-class pointers, each a heap allocation of its own.
#pragma once

#include <memory>
#include <vector>

#include "../../material_object.h"
#include "layout.h"

namespace ctpbench {

struct VirtualMaterials {
    const MaterialBase* const* objects;

    CTP_INLINE Scattering sample(MaterialWord word, const SurfacePoint& point,
                                 const PathRandom& random) const {
        return objects[word.number()]->sample(point, random);
    }
};

template <class Types>
struct ShadeOop {
    static constexpr const char* name = "oop";
    static constexpr PathOrder order = PathOrder::as_traced;

    class Layout {
    public:
        explicit Layout(const MaterialInput& in) {
            in.for_each<Types>([&](const auto& material) {
                using T = std::remove_cvref_t<decltype(material)>;
                objects_.push_back(std::make_unique<MaterialObject<T>>(material));
                pointers_.push_back(objects_.back().get());
            });
        }
        // Of the host alone: objects are constructed where their virtual tables are.
        VirtualMaterials view(HostPlace) const { return {pointers_.data()}; }

    private:
        std::vector<std::unique_ptr<MaterialBase>> objects_;
        Array<const MaterialBase*> pointers_;
    };

    template <class Offset, class View, class ForEach>
    static void shade(const View& view, const ShadeBuffers& io, const ShadeWork& work, ForEach&& for_each) {
        shade_in_one_kernel<Offset>(view, io, work, for_each);
    }
};

}  // namespace ctpbench
