#include "monomorphic/matte_shader.h"

#include <stdexcept>

namespace ctpbench::monomorphic {
namespace {

struct ShadeKernel {
    const Vec3* positions;
    const std::array<std::uint32_t, 3>* triangles;
    const std::uint32_t* material;
    const Vec3* albedo;
    RayColumns rays;
    HitColumns hits;
    PixelColumns pixels;
    const std::uint32_t* index;
    std::uint8_t* fates;
    std::uint64_t seed;
    std::uint32_t sample, bounce, roulette_from;
    Vec3 ambient;

    void operator()(std::uint32_t i) const { fates[i] = static_cast<std::uint8_t>(shade(index[i])); }

private:
    CTP_INLINE PathFate shade(std::uint32_t slot) const {
        const std::uint32_t id = hits.primitive[slot];
        if (id == kNoPrimitive) {
            pixels.add_radiance(slot, ambient);
            return PathFate::ended;
        }
        const std::array<std::uint32_t, 3>& corners = triangles[id];
        const Vec3 a = positions[corners[0]];
        const Vec3 e1 = positions[corners[1]] - a, e2 = positions[corners[2]] - a;
        const Vec3 point = a + (hits.u[slot] * e1 + hits.v[slot] * e2);
        Vec3 normal = normalize(cross(e1, e2));
        if (dot(normal, {rays.dx[slot], rays.dy[slot], rays.dz[slot]}) > 0.0f) normal = -normal;

        const Random4 r = random4(seed, slot, sample, bounce, Dimension::direction);
        const Vec3 direction = cosine_direction(normal, r.v[0], r.v[1]);
        pixels.scale_throughput(slot, albedo[material[id]]);
        if (bounce >= roulette_from && !survives(pixels, slot, {seed, slot, sample, bounce}))
            return PathFate::ended;
        const Vec3 origin = WaechterBinder::origin(point, normal, direction, hits.t[slot]);
        rays.store(slot, {origin, direction, std::numeric_limits<float>::infinity()});
        return PathFate::goes_on;
    }
};

}  // namespace

MatteShader::MatteShader(const Scene& scene)
    : material_(scene.mesh.material.begin(), scene.mesh.material.end()) {
    if (!scene.spheres.empty()) throw std::invalid_argument("the scene has spheres");
    for (const Material& m : scene.materials) {
        if (m.look.type != material_type<Matte> || m.look.texture.exists())
            throw std::invalid_argument("material \"" + m.name + "\" is not matte of one colour");
        albedo_.push_back(m.look.diffuse);
    }
}

void MatteShader::shade(CpuBackend& backend, const ShadeBuffers& io, const ShadeWork& work) const {
    backend.for_each(work.count, ShadeKernel{io.geometry.positions, io.geometry.triangles, material_.data(),
                                             albedo_.data(), io.rays, io.hits, io.pixels, io.index, io.fates,
                                             io.seed, io.sample, io.bounce, io.roulette_from, io.ambient});
}

}  // namespace ctpbench::monomorphic
