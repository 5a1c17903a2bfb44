// The shade stage of a renderer whose every surface is a Lambertian triangle of one colour, written by hand:
// what shade strategies should cost once they are narrowed to a list of that one material. No material word,
// visitor, texture or sphere is in it. The arithmetic is the shared one, so that images are the same bit for
// bit.
#pragma once

#include "scene/scene.h"
#include "wavefront/shader.h"

namespace ctpbench::monomorphic {

class MatteShader final : public Shader {
public:
    // Copies what it needs of the scene. Throws if it has spheres, textures or another material.
    explicit MatteShader(const Scene& scene);

    PathOrder order() const override { return PathOrder::as_traced; }
    MaterialWords words() const override { return {nullptr, 0, {}, 1}; }  // nobody looks at them
    void count(const MaterialInput&, const CountingPlace&) const override {}
    void shade(CpuBackend& backend, const ShadeBuffers& io, const ShadeWork& work) const override;

private:
    Array<std::uint32_t> material_;  // of each triangle
    Array<Vec3> albedo_;             // of each material
};

}  // namespace ctpbench::monomorphic
