#include "scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene/content_hash.h"
#include "scene/framing.h"

namespace ctpbench {
namespace {

Scene sample() {
    Scene scene;
    scene.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {99, 99, 99}};  // no triangle uses the last
    scene.mesh.triangles = {{0, 1, 2}};
    scene.mesh.material = {0};
    scene.materials = {{"grey", {{0.5f, 0.5f, 0.5f}}}};
    return scene;
}

TEST(SceneBounds, AreOfTrianglesAndSpheres) {
    Scene scene = sample();
    EXPECT_EQ(scene_bounds(scene).lo, (Vec3{0, 0, 0}));
    EXPECT_EQ(scene_bounds(scene).hi, (Vec3{1, 2, 0}));
    scene.spheres = {{{5, 0, 0}, 2}};
    EXPECT_EQ(scene_bounds(scene).lo, (Vec3{0, -2, -2}));
    EXPECT_EQ(scene_bounds(scene).hi, (Vec3{7, 2, 2}));
    EXPECT_TRUE(scene_bounds(Scene{}).is_empty());
}

TEST(ContentHash, ShowsEveryChangeOfContent) {
    const std::uint64_t hash = content_hash(sample());
    const auto expect_changed = [&](auto&& change) {
        Scene scene = sample();
        change(scene);
        EXPECT_NE(content_hash(scene), hash);
    };
    expect_changed([](Scene& s) { s.mesh.positions[0].x = -0.0f; });
    expect_changed([](Scene& s) { s.mesh.triangles[0] = {1, 2, 0}; });
    expect_changed([](Scene& s) { s.mesh.material[0] = 1; });
    expect_changed([](Scene& s) { s.mesh.texcoords.resize(1); });
    expect_changed([](Scene& s) { s.texels.push_back({1, 2, 3, 4}); });
    expect_changed([](Scene& s) { s.ambient.z = 0.5f; });
    expect_changed([](Scene& s) { s.materials[0].look.type = 1; });
    expect_changed([](Scene& s) { s.spheres.push_back({{0, 0, 0}, 1}); });
    expect_changed([](Scene& s) { s.materials[0].look.diffuse.y = 0.6f; });
    expect_changed([](Scene& s) { s.materials[0].name = "gray"; });
    expect_changed([](Scene& s) { s.materials.push_back({}); });
}

TEST(ContentHash, DoesNotDependOnTheView) {
    Scene scene = sample();
    scene.name = "other";
    scene.camera.eye = {1, 2, 3};
    scene.exposure = 2.0f;
    scene.source = SceneSource::stand_in;
    EXPECT_EQ(content_hash(scene), content_hash(sample()));
}

TEST(FramingCamera, SeesEveryCornerOfTheBox) {
    const Box box{{-5, 0, 100}, {10, 1, 103}};
    const Camera camera = framing_camera(box);
    const Vec3 forward = normalize(camera.target - camera.eye);
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 at{corner & 1 ? box.lo.x : box.hi.x, corner & 2 ? box.lo.y : box.hi.y,
                      corner & 4 ? box.lo.z : box.hi.z};
        const float angle =
            std::acos(dot(normalize(at - camera.eye), forward)) * 180.0f / std::numbers::pi_v<float>;
        EXPECT_LE(angle, 0.5f * camera.fov_degrees + 1e-3f);
    }
}

}  // namespace
}  // namespace ctpbench
