// Scenes of triangles in plain colours alone.
#pragma once

#include "kernels/materials/list.h"
#include "scene/content_hash.h"
#include "scene/scene.h"

namespace ctpbench::monomorphic {

// Takes the spheres and the textures away and makes every material matte. Mirrors, which have no diffuse
// colour, get their specular one.
inline void make_matte(Scene& scene) {
    scene.spheres.clear();
    scene.mesh.texcoords.clear();
    scene.texels.clear();
    for (Material& m : scene.materials) {
        MaterialDescription matte;
        matte.type = material_type<Matte>;
        matte.diffuse = max(m.look.diffuse, m.look.specular);
        m.look = matte;
    }
    scene.content_hash = content_hash(scene);
}

}  // namespace ctpbench::monomorphic
