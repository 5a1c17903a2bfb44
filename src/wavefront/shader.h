// One contender of the shade stage with its materials laid out. The virtual call is one per bounce; how it
// branches per path is inside.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "backends/cpu.h"
#include "kernels/dispatch/shade/layout.h"

namespace ctpbench {

class Shader {
public:
    virtual ~Shader() = default;
    virtual PathOrder order() const = 0;
    virtual void shade(CpuBackend& backend, const ShadeBuffers& io, const ShadeWork& work) const = 0;
};

// The names of the registry, in its order.
std::vector<std::string> shade_strategies();

// The name must be registered.
std::unique_ptr<Shader> make_shader(std::string_view strategy, const MaterialInput& materials);

}  // namespace ctpbench
