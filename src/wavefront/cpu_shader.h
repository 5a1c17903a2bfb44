// A shade strategy on CPU threads. Included where groups are instantiated, and nowhere else.
#pragma once

#include "kernels/registry.h"
#include "wavefront/shader_groups.h"

namespace ctpbench {

template <class Strategy, class Offset>
class CpuShader final : public Shader {
public:
    explicit CpuShader(const MaterialInput& materials) : layout_(materials) {}

    PathOrder order() const override { return Strategy::order; }
    bool excludes() const override { return Offset::excludes; }
    void shade(CpuBackend& backend, const ShadeBuffers& io, const ShadeWork& work) const override {
        const auto for_each = [&](std::uint32_t count, const auto& kernel, std::uint32_t grain = 1024) {
            backend.for_each(count, kernel, grain);
        };
        Strategy::template shade<Offset>(layout_.view(HostPlace{}), io, work, for_each);
    }

private:
    typename Strategy::Layout layout_;
};

template <class Offset>
std::unique_ptr<Shader> make_with_offset(std::string_view strategy, const MaterialInput& materials) {
    std::unique_ptr<Shader> made;
    for_each_type(ShadeStrategies{}, [&](auto tag) {
        using Strategy = typename decltype(tag)::type;
        if (strategy == Strategy::name) made = std::make_unique<CpuShader<Strategy, Offset>>(materials);
    });
    return made;
}

}  // namespace ctpbench
