// The hand-written kernels are a yardstick of time, which says something only as long as they compute the
// same: their hits and images are those of the strategies bit for bit.
#include <gtest/gtest.h>

#include <stdexcept>
#include <tuple>

#include "monomorphic/contenders.h"
#include "monomorphic/matte_scene.h"
#include "scene/load_scene.h"
#include "wavefront/motley.h"

namespace ctpbench {
namespace {

using monomorphic::kByHand;

Scene matte_soup() {
    Scene scene = test::motley();
    monomorphic::make_matte(scene);
    scene.camera = test::kMotleyCamera;
    return scene;
}

Scene matte_room() {
    SceneRequest request;
    request.name = "smoke";
    Notices notices;
    Scene scene = load_scene(request, notices);
    monomorphic::make_matte(scene);
    return scene;
}

struct Traced {
    std::vector<std::uint64_t> hits;  // hashes by sample and bounce
    std::uint64_t image = 0;
    bool operator==(const Traced&) const = default;
};
void PrintTo(const Traced& t, std::ostream* out) { *out << t.hits.size() << " bounces, image " << t.image; }

Traced trace(monomorphic::Stage& stage, const std::string& intersect, const std::string& shade,
             std::uint32_t roulette_from = kNoRoulette) {
    const FrameSettings settings{101, 67, 6, 9, false, roulette_from};
    const auto intersector = monomorphic::intersector_of(stage, intersect);
    const auto shader = monomorphic::shader_of(stage, shade);
    Renderer renderer(stage.backend, stage.view, stage.scene.camera, settings);
    Traced traced;
    ImageStorage image;
    for (std::uint32_t sample = 0; sample < 3; ++sample)
        renderer.frame(*intersector, *shader, true, sample, image, [&](const BounceView& view) {
            const Batch batch = record_batch(view.bounce, view.rays, view.slots, 0);
            traced.hits.push_back(record_hits(batch, view.hits).hash());
        });
    traced.image = image.hash();
    return traced;
}

void expect_the_same(const Scene& scene) {
    for (const int threads : {1, 2}) {
        monomorphic::Stage stage(scene, threads, {TreeKind::mixed});
        for (const std::uint32_t roulette_from : {kNoRoulette, 1u}) {
            const Traced expected = trace(stage, "ctp", "ctp", roulette_from);
            EXPECT_EQ(expected.hits.size(), 3u * 7u);
            EXPECT_EQ(trace(stage, kByHand, "ctp", roulette_from), expected) << threads << " threads";
            EXPECT_EQ(trace(stage, "ctp", kByHand, roulette_from), expected) << threads << " threads";
            EXPECT_EQ(trace(stage, kByHand, kByHand, roulette_from), expected) << threads << " threads";
        }
    }
}

TEST(Monomorphic, GivesTheHitsAndImagesOfCtpInASoup) { expect_the_same(matte_soup()); }
TEST(Monomorphic, GivesTheHitsAndImagesOfCtpInARoom) { expect_the_same(matte_room()); }

TEST(Monomorphic, NothingToHit) {
    Scene scene = matte_soup();
    scene.mesh = {};
    monomorphic::Stage stage(scene, 1, {TreeKind::mixed});
    EXPECT_EQ(trace(stage, kByHand, kByHand), trace(stage, "ctp", "ctp"));
}

// The scenes are worth the test: several colours, light from outside, and each of them matters.
TEST(Monomorphic, IsTestedOnScenesWhereColoursMatter) {
    Scene scene = matte_soup();
    monomorphic::Stage stage(scene, 1, {TreeKind::mixed});
    const std::uint64_t image = trace(stage, kByHand, kByHand).image;
    for (Material& m : scene.materials) {
        Material before = m;
        m.look.diffuse = 0.5f * m.look.diffuse + Vec3{0.1f, 0.0f, 0.0f};
        EXPECT_NE(trace(stage, kByHand, kByHand).image, image);
        m = before;
    }
    EXPECT_EQ(trace(stage, kByHand, kByHand).image, image);
}

TEST(Monomorphic, RefusesWhatItDoesNotKnow) {
    Scene scene = matte_soup();
    scene.spheres = {{{0, 0, 0}, 0.1f}};
    {
        const monomorphic::Stage stage(scene, 1, {TreeKind::mixed});
        EXPECT_THROW(monomorphic::intersector_of(stage, kByHand), std::invalid_argument);
        EXPECT_THROW(monomorphic::shader_of(stage, kByHand), std::invalid_argument);
    }
    scene.spheres.clear();
    scene.materials[1].look.type = material_type<Plastic>;
    const monomorphic::Stage stage(scene, 1, {TreeKind::mixed});
    EXPECT_THROW(monomorphic::shader_of(stage, kByHand), std::invalid_argument);
    EXPECT_THROW(monomorphic::intersector_of(stage, "abc"), std::invalid_argument);
    EXPECT_THROW(monomorphic::shader_of(stage, "abc"), std::invalid_argument);
}

}  // namespace
}  // namespace ctpbench
