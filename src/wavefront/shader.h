// One contender of the shade stage with its materials laid out. The virtual call is one per bounce; how it
// branches per path is inside.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "backends/cpu.h"
#include "kernels/methods/offset_waechter_binder.h"
#include "wavefront/material_table.h"

namespace ctpbench {

class CountingPlace;

class Shader {
public:
    virtual ~Shader() = default;
    virtual PathOrder order() const = 0;
    // Whether it writes ShadeBuffers::excluded, which the intersector must then heed.
    virtual bool excludes() const { return false; }
    // Of the table that it was made from. Its intersector records keys by these.
    virtual MaterialWords words() const = 0;
    // As Intersector::count().
    virtual void count(const MaterialInput& materials, const CountingPlace& place) const = 0;
    virtual void shade(CpuBackend& backend, const ShadeBuffers& io, const ShadeWork& work) const = 0;
};

// The names of the registry, in its order.
std::vector<std::string> shade_strategies();

// Lays out `strategy`, compiled for the table's types. `offset` is the name of one of offsets()
// (wavefront/methods.h). Both must be registered, and the table must outlive the shader.
std::unique_ptr<Shader> make_shader(std::string_view strategy, const MaterialTable& materials,
                                    std::string_view offset = WaechterBinder::name);

}  // namespace ctpbench
