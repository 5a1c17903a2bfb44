// A shade strategy on CPU threads. Included where groups are instantiated, and nowhere else.
#pragma once

#include "kernels/registry.h"
#include "wavefront/counting_place.h"
#include "wavefront/placed_materials.h"
#include "wavefront/shader_groups.h"

namespace ctpbench {

template <class Strategy, class Offset>
class CpuShader final : public Shader {
public:
    explicit CpuShader(const MaterialTable& materials)
        : words_(materials.words()), layout_(materials.input()) {}

    PathOrder order() const override { return Strategy::order; }
    bool excludes() const override { return Offset::excludes; }
    MaterialWords words() const override { return words_; }
    void count(const MaterialInput& materials, const CountingPlace& place) const override {
        materials_in<Strategy>(place, materials);
    }
    void shade(CpuBackend& backend, const ShadeBuffers& io, const ShadeWork& work) const override {
        const auto for_each = [&](std::uint32_t count, const auto& kernel, std::uint32_t grain = 1024) {
            backend.for_each(count, kernel, grain);
        };
        Strategy::template shade<Offset>(layout_.view(HostPlace{}), io, work, for_each);
    }

private:
    MaterialWords words_;
    typename Strategy::Layout layout_;
};

template <class Offset, class Types>
std::unique_ptr<Shader> make_with_types(std::string_view strategy, const MaterialTable& materials) {
    std::unique_ptr<Shader> made;
    for_each_type(ShadeStrategies<Types>{}, [&](auto tag) {
        using Strategy = typename decltype(tag)::type;
        if (strategy == Strategy::name) made = std::make_unique<CpuShader<Strategy, Offset>>(materials);
    });
    return made;
}

template <class Offset>
std::unique_ptr<Shader> make_with_offset(std::string_view strategy, const MaterialTable& materials) {
    std::unique_ptr<Shader> made;
    visit_material_list<Offset>(materials.input().types, [&](auto list) {
        made = make_with_types<Offset, typename decltype(list)::type>(strategy, materials);
    });
    return made;
}

}  // namespace ctpbench
