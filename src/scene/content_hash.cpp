#include "scene/content_hash.h"

#include "base/hash.h"

namespace ctpbench {

// Each hash seeds the next. XXH3 depends on the length too, so moving an element to the next array shows.
std::uint64_t content_hash(const Scene& scene) {
    std::uint64_t hash = hash_vector(scene.mesh.positions);
    hash = hash_vector(scene.mesh.triangles, hash);
    hash = hash_vector(scene.mesh.material, hash);
    hash = hash_vector(scene.mesh.texcoords, hash);
    hash = hash_vector(scene.spheres, hash);
    for (const Material& material : scene.materials) {
        hash = hash_bytes(material.name.data(), material.name.size(), hash);
        hash = hash_bytes(&material.look, sizeof(material.look), hash);
    }
    hash = hash_vector(scene.texels, hash);
    hash = hash_bytes(&scene.ambient, sizeof(scene.ambient), hash);
    return hash_bytes(&scene.sphere_material, sizeof(scene.sphere_material), hash);
}

}  // namespace ctpbench
