// The explicit instantiations of every shade strategy, on CPU threads.
#include "wavefront/shader.h"

#include "kernels/registry.h"

namespace ctpbench {
namespace {

template <class Strategy>
class CpuShader final : public Shader {
public:
    explicit CpuShader(const MaterialInput& materials) : layout_(materials) {}

    PathOrder order() const override { return Strategy::order; }
    void shade(CpuBackend& backend, const ShadeBuffers& io, const ShadeWork& work) const override {
        Strategy::shade(layout_.view(HostPlace{}), io, work,
                        [&](std::uint32_t count, const auto& kernel, std::uint32_t grain = 1024) {
                            backend.for_each(count, kernel, grain);
                        });
    }

private:
    typename Strategy::Layout layout_;
};

}  // namespace

std::vector<std::string> shade_strategies() {
    std::vector<std::string> names;
    for_each_type(ShadeStrategies{}, [&](auto tag) { names.push_back(decltype(tag)::type::name); });
    return names;
}

std::unique_ptr<Shader> make_shader(std::string_view strategy, const MaterialInput& materials) {
    std::unique_ptr<Shader> made;
    for_each_type(ShadeStrategies{}, [&](auto tag) {
        using Strategy = typename decltype(tag)::type;
        if (strategy == Strategy::name) made = std::make_unique<CpuShader<Strategy>>(materials);
    });
    if (!made) trap();
    return made;
}

}  // namespace ctpbench
