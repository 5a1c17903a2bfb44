// A path that leaves out the primitive it comes from, end to end.
#include <gtest/gtest.h>

#include "config/axes.h"
#include "wavefront/cpu_tracer.h"
#include "wavefront/methods.h"
#include "wavefront/motley.h"
#include "wavefront/physics.h"

namespace ctpbench {
namespace {

const std::string kExcluding = intersect_methods("watertight", of_bundle, of_bundle, of_bundle, "exclude_id");

// Every hit of every bounce is on another triangle than the one that the path left, and what is recorded of
// the bounce finds the same hits again.
TEST(ExcludeId, APathNeverHitsTheTriangleThatItLeft) {
    const Scene scene = test::motley();
    for (const std::string& shade : shade_strategies()) {
        test::Stage stage(scene, 2, "ctp", kExcluding);
        std::vector<std::uint32_t> left(61 * 43, kNoPrimitive);
        std::uint32_t hits = 0;
        test::render(
            stage, test::kMotleyCamera, {61, 43, 6, 9}, 2, shade,
            [&](const BounceView& view) {
                ASSERT_NE(view.excluded, nullptr);
                Batch batch = record_batch(view.bounce, view.rays, view.slots, 0, view.excluded);
                HitStorage hits_of_batch = record_hits(batch, view.hits);
                const float extent = stage.view.geometry().extent;
                EXPECT_EQ(CpuTracer(stage.backend, *stage.intersector, extent).trace(batch, true).hash,
                          hits_of_batch.hash())
                    << shade << ", bounce " << view.bounce;
                for (const std::uint32_t slot : view.slots) {
                    if (view.bounce == 0) left[slot] = kNoPrimitive;
                    ASSERT_EQ(view.excluded[slot], left[slot]) << shade << ", bounce " << view.bounce;
                    const std::uint32_t id = view.hits.primitive[slot];
                    if (id == kNoPrimitive) continue;
                    ASSERT_NE(id, left[slot]) << shade << ", bounce " << view.bounce;
                    left[slot] = id, ++hits;
                }
            },
            "exclude_id");
        EXPECT_GT(hits, 3000u) << shade;
    }
}

// Where nothing can be hit twice by mistake, the image is the default's but for the origins' last digits.
TEST(ExcludeId, ShowsTheSameLight) {
    Scene scene;
    const std::uint32_t walls = test::add_material(scene, test::matte(test::gray(0.7f)));
    Mesh room = test::star(3, 1.0f, {0, 0, 0}, 3);
    test::add_mesh(scene, room, walls);
    const std::uint32_t lamp = test::add_material(scene, test::emissive(test::gray(5.0f)));
    test::add_square(scene, 0.2f, 0.3f, lamp);
    scene.ambient = test::gray(0.0f);
    const Camera camera = test::looking_from({0.1f, 0.2f, -0.4f}, {0, 0, 0.5f});
    const FrameSettings settings{48, 48, 8, 3};
    test::Stage plain(scene, 2), excluding(scene, 2, "ctp", kExcluding);
    const auto expected = test::render(plain, camera, settings, 16);
    const auto image = test::render(excluding, camera, settings, 16, "ctp", {}, "exclude_id");
    test::Mean difference, mean;
    for (std::size_t i = 0; i < image.image.size(); ++i) {
        difference.add(image.image.at(i).x - expected.image.at(i).x);
        mean.add(expected.image.at(i).x);
    }
    EXPECT_GT(mean.value(), 0.1);
    EXPECT_NEAR(difference.value(), 0.0, 4.0 * difference.sigma() + 1e-6 * mean.value());
}

// Without a column nothing is left out: the same hits as without the policy.
TEST(ExcludeId, WithoutAColumnItIsTheDefault) {
    const Scene scene = test::soup(600, 200, 17);
    test::Stage plain(scene, 2), excluding(scene, 2, "ctp", kExcluding);
    EXPECT_TRUE(excluding.intersector->excludes());
    EXPECT_FALSE(plain.intersector->excludes());
    RayStorage rays;
    rays.resize(2000);
    test::Random random(5);
    std::vector<std::uint32_t> slots(rays.size());
    for (std::uint32_t i = 0; i < rays.size(); ++i) {
        rays.view().store(i, {random.point(-1, 1), random.direction(), test::kInfinity});
        slots[i] = i;
    }
    Batch batch = record_batch(0, rays.view(), slots, 0);
    const float extent = plain.view.geometry().extent;
    CpuTracer tracer(plain.backend, *plain.intersector, extent);
    const std::uint64_t expected = tracer.trace(batch, true).hash;
    CpuTracer other(excluding.backend, *excluding.intersector, extent);
    EXPECT_EQ(other.trace(batch, true).hash, expected);

    // With the first hits excluded each ray finds another primitive, or none.
    for (std::uint32_t i = 0; i < rays.size(); ++i)
        batch.excluded.push_back(tracer.hits().view().primitive[i]);
    EXPECT_EQ(tracer.trace(batch, true).hash, expected) << "the default does not look";
    other.trace(batch, true);
    std::uint32_t hits = 0;
    for (std::uint32_t i = 0; i < rays.size(); ++i) {
        const Hit first = tracer.hits().view().load(i), second = other.hits().view().load(i);
        if (first.primitive == kNoPrimitive) continue;
        ++hits;
        EXPECT_NE(second.primitive, first.primitive);
        EXPECT_GE(second.t, first.t);
    }
    EXPECT_GT(hits, 500u);
}

TEST(ExcludeIdDeath, AShaderThatExcludesRefusesAnIntersectorThatDoesNot) {
    const Scene scene = test::motley();
    test::Stage stage(scene, 1);
    EXPECT_DEATH(test::render(stage, test::kMotleyCamera, {8, 8, 1, 1}, 1, "ctp", {}, "exclude_id"), "");
}

}  // namespace
}  // namespace ctpbench
