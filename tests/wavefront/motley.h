// A scene that shading tests share: it has all that materials do.
#pragma once

#include <algorithm>

#include "kernels/materials/list.h"
#include "support.h"
#include "wavefront/frames.h"

namespace ctpbench::test {

inline Material material(std::uint32_t type, Vec3 diffuse, Vec3 specular = {0, 0, 0}, float exponent = 0) {
    Material m;
    m.look.type = type, m.look.diffuse = diffuse, m.look.specular = specular, m.look.exponent = exponent;
    return m;
}

// A soup of triangles and spheres with every type of material, textured and not, some of it cut out by alpha.
inline Scene motley() {
    Scene scene = soup(3000, 60, 11);
    scene.materials = {material(material_type<Matte>, {0.8f, 0.5f, 0.3f}),
                       material(material_type<Plastic>, {0.4f, 0.4f, 0.6f}, {0.3f, 0.3f, 0.3f}, 60),
                       material(material_type<Mirror>, {0, 0, 0}, {0.9f, 0.8f, 0.7f}),
                       material(material_type<Emissive>, {0, 0, 0}),
                       material(material_type<Matte>, {1, 1, 1}),
                       material(material_type<Plastic>, {0.9f, 0.9f, 0.9f}, {0.2f, 0.1f, 0.1f}, 5)};
    scene.materials[3].look.emission = {3, 2, 1};
    Random random(3);
    for (int i = 0; i < 7 * 5; ++i)
        scene.texels.push_back({static_cast<std::uint16_t>(random.uniform(0, 65535)),
                                static_cast<std::uint16_t>(random.uniform(0, 65535)),
                                static_cast<std::uint16_t>(random.uniform(0, 65535)),
                                static_cast<std::uint16_t>(i % 3 == 0 ? 0 : 65535)});
    scene.materials[4].look.texture = {0, 7, 5};
    scene.materials[5].look.texture = {14, 7, 3};
    for (std::uint32_t type = 0; type < Materials::size; ++type)
        if (std::none_of(scene.materials.begin(), scene.materials.end(),
                         [&](const Material& m) { return m.look.type == type; }))
            scene.materials.push_back(material(type, {0.4f, 0.5f, 0.3f}, {0.3f, 0.2f, 0.4f}, 20));
    for (std::size_t i = 0; i < scene.mesh.triangles.size(); ++i) {
        scene.mesh.material[i] = static_cast<std::uint32_t>(i % scene.materials.size());
        const auto corner = [&] { return Vec2{random.uniform(-2, 3), random.uniform(-2, 3)}; };
        scene.mesh.texcoords.push_back({corner(), corner(), corner()});
    }
    scene.sphere_material = 2;
    scene.ambient = {0.3f, 0.5f, 0.7f};
    return scene;
}

inline const Camera kMotleyCamera = looking_from({0.2f, 0.1f, 2.5f}, {0, 0, 0});

}  // namespace ctpbench::test
