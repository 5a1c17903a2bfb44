// Models no more than a scene needs: what no ray can ever ask for is neither kept nor uploaded.
//
// There are no normals to drop: they are geometric, and computed where they are needed.
#pragma once

#include "scene/scene.h"

namespace ctpbench {

// Takes out
//     vertices that no triangle has; the rest keep their order,
//     materials that neither a triangle nor the spheres have,
//     materials of the type of an earlier one that make the same object as it, bit for bit, whatever their
//         names: who had them has the earlier one,
//     texture coordinates and texels if no material that is left has a texture.
// If nothing uses a material, the first stays. Triangles keep their order and thereby their ids, and both
// they and the spheres look as before. Counts in scene.savings; a second call takes out nothing.
//
// Of a scene with a texture all texels stay: load_textures() reads none that is not used.
void trim(Scene& scene);

}  // namespace ctpbench
