#include "scene/content_hash.h"

#include <vector>

#include "base/hash.h"

namespace ctpbench {
namespace {

// Each hash seeds the next. XXH3 depends on the length too, so moving an element to the next array shows.

std::uint64_t mesh_hash(const Mesh& mesh) {
    std::uint64_t hash = hash_vector(mesh.positions);
    hash = hash_vector(mesh.triangles, hash);
    hash = hash_vector(mesh.material, hash);
    return hash_vector(mesh.texcoords, hash);
}

std::uint64_t material_hash(const Material& material, std::uint64_t hash) {
    hash = hash_bytes(material.name.data(), material.name.size(), hash);
    return hash_bytes(&material.look, sizeof(material.look), hash);
}

}  // namespace

std::uint64_t content_hash(const Scene& scene) {
    std::uint64_t hash = mesh_hash(scene.mesh);
    hash = hash_vector(scene.spheres, hash);
    for (const Material& material : scene.materials) hash = material_hash(material, hash);
    hash = hash_vector(scene.texels, hash);
    hash = hash_bytes(&scene.ambient, sizeof(scene.ambient), hash);
    return hash_bytes(&scene.sphere_material, sizeof(scene.sphere_material), hash);
}

std::uint64_t base_hash(const Scene& scene) {
    std::uint64_t hash = mesh_hash(scene.mesh);
    // The spheres' material comes last, or is one of the triangles'.
    std::vector<bool> used(scene.materials.size());
    for (const std::uint32_t material : scene.mesh.material) used[material] = true;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) hash = material_hash(scene.materials[i], hash);
    hash = hash_vector(scene.texels, hash);
    hash = hash_bytes(&scene.ambient, sizeof(scene.ambient), hash);
    hash = hash_bytes(&scene.camera, sizeof(scene.camera), hash);
    return hash_bytes(&scene.exposure, sizeof(scene.exposure), hash);
}

}  // namespace ctpbench
