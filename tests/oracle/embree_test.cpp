// Each way in which Embree traces must give the hits of the scene, wherever its rays lie in the columns.
#include "oracle/embree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

#include "oracle/check.h"
#include "scene/load_scene.h"
#include "support.h"
#include "wavefront/frames.h"

namespace ctpbench {
namespace {

using test::kInfinity;

Scene smoke_with_spheres() {
    SceneRequest request;
    request.name = "smoke", request.spheres = 200, request.sphere_radius = 0.15f;
    Notices notices;
    return load_scene(request, notices);
}

constexpr float kUntouched = -7.0f;

// Rays of two bounces, one in five with an end, and what our default contender hits.
class EmbreeTest : public testing::Test {
protected:
    EmbreeTest() : scene_(smoke_with_spheres()), stage_(scene_, 2), judge_(stage_.view.geometry()) {
        test::render(stage_, scene_.camera, {96, 64, 1, 1}, 1, "ctp", [&](const BounceView& view) {
            for (const std::uint32_t slot : view.slots) rays_.push_back(view.rays.load(slot));
        });
        for (std::size_t i = 0; i < rays_.size(); i += 5) rays_[i].tmax = 0.2f;
    }
    void SetUp() override {
        if (embree_version().empty()) GTEST_SKIP() << "built without Embree";
        for (const EmbreeMode mode : {EmbreeMode::fast, EmbreeMode::robust})
            scenes_.push_back(std::make_shared<const EmbreeScene>(scene_, mode, 2));
    }

    // Ray i is in slot `slots[i]`; other slots hold a ray that hits nothing and must not be traced.
    HitStorage trace(const Intersector& intersector, const std::vector<std::uint32_t>& slots) {
        const std::uint32_t last = *std::max_element(slots.begin(), slots.end());
        RayStorage rays;
        HitStorage hits;
        rays.resize(last + 64), hits.resize(last + 64);
        for (std::uint32_t s = 0; s < hits.size(); ++s) {
            rays.view().store(s, {{1e6f, 1e6f, 1e6f}, {1, 0, 0}, kInfinity});
            hits.view().store(s, {kUntouched, 0, kUntouched, kUntouched});
        }
        for (std::size_t i = 0; i < slots.size(); ++i) rays.view().store(slots[i], rays_[i]);
        intersector.intersect(stage_.backend,
                              {rays.view(), hits.view(), slots.data(),
                               static_cast<std::uint32_t>(slots.size()), stage_.view.geometry().extent},
                              true);
        const std::set<std::uint32_t> traced(slots.begin(), slots.end());
        for (std::uint32_t s = 0; s < hits.size(); ++s)
            EXPECT_EQ(hits.view().t[s] == kUntouched, traced.count(s) == 0) << "slot " << s;
        return hits;
    }

    void expect_hits_of_the_scene(const std::vector<std::uint32_t>& slots, const std::string& layout) {
        HitStorage ours = trace(*stage_.intersector, slots);
        for (const EmbreeContender& e : embree_contenders()) {
            if (!embree_obstacle(e.name).empty()) continue;
            SCOPED_TRACE(e.name + ", " + layout);
            const auto embree = make_embree(scenes_[e.mode == EmbreeMode::robust], e.call, e.coherent);
            HitStorage theirs = trace(*embree, slots);
            Verdict verdict;
            std::size_t spheres = 0, misses = 0;
            for (std::size_t i = 0; i < slots.size(); ++i) {
                const Hit hit = theirs.view().load(slots[i]), ours_hit = ours.view().load(slots[i]);
                judge_.ray(rays_[i], hit, ours_hit, verdict);
                if (hit.primitive == kNoPrimitive) {
                    ++misses;
                    EXPECT_EQ(hit.t, rays_[i].tmax);
                }
                const bool flat = hit.primitive < stage_.view.geometry().first_sphere();
                spheres += !flat && hit.primitive != kNoPrimitive;
                EXPECT_TRUE(flat || (hit.u == 0.0f && hit.v == 0.0f));
                if (flat && hit.primitive == ours_hit.primitive) {
                    EXPECT_NEAR(hit.u, ours_hit.u, 2e-3);
                    EXPECT_NEAR(hit.v, ours_hit.v, 2e-3);
                }
            }
            EXPECT_TRUE(verdict.accepted(false)) << verdict.text();
            EXPECT_LT(verdict.mismatch_rate(), 0.005) << verdict.text();
            if (slots.size() > 1000) {
                EXPECT_GT(spheres, 20u);
                EXPECT_GT(misses, 20u);
            }
        }
    }

    std::vector<std::uint32_t> in_order(std::uint32_t count, std::uint32_t first = 0) const {
        std::vector<std::uint32_t> slots(count);
        std::iota(slots.begin(), slots.end(), first);
        return slots;
    }

    Scene scene_;
    test::Stage stage_;
    Judge judge_;
    std::vector<Ray> rays_;
    std::vector<std::shared_ptr<const EmbreeScene>> scenes_;
};

TEST_F(EmbreeTest, EveryModeGivesTheHitsOfTheScene) {
    const auto n = static_cast<std::uint32_t>(rays_.size());
    ASSERT_GT(n, 7000u);
    expect_hits_of_the_scene(in_order(n - n % 16 - 3), "a tail of 13");
    expect_hits_of_the_scene(in_order(2048 + 1), "a tail of 1");
}

TEST_F(EmbreeTest, WhateverTheNumberOfRays) {
    for (const std::uint32_t n : {1u, 15u, 16u, 17u, 1023u, 1024u, 1025u})
        expect_hits_of_the_scene(in_order(n), std::to_string(n) + " rays");
}

TEST_F(EmbreeTest, WhereverTheRaysAre) {
    constexpr std::uint32_t n = 3003;
    for (const std::uint32_t first : {1u, 4u, 48u})
        expect_hits_of_the_scene(in_order(n, first), "from slot " + std::to_string(first));
    std::vector<std::uint32_t> slots = in_order(n);
    for (std::uint32_t i = 0; i < n; ++i) slots[i] = n - 1 - i;
    expect_hits_of_the_scene(slots, "backwards");
    for (std::uint32_t i = 0; i < n; ++i) slots[i] = 3 * i;
    expect_hits_of_the_scene(slots, "with gaps");
    slots = in_order(n);
    std::swap(slots[1023], slots[2050]);
    expect_hits_of_the_scene(slots, "in order but for two");
}

TEST(EmbreeContenders, SayWhyTheyCannotBeHad) {
    EXPECT_EQ(embree_obstacle("ctp"), "");
    for (const EmbreeContender& e : embree_contenders()) {
        const bool stream = e.name.find("stream") != std::string::npos;
        EXPECT_EQ(stream, e.call == EmbreeCall::stream) << e.name;
        EXPECT_EQ(e.name.find("_robust") != std::string::npos, e.mode == EmbreeMode::robust) << e.name;
        EXPECT_EQ(e.name.find("_coherent") != std::string::npos, e.coherent) << e.name;
        const std::string why = embree_obstacle(e.name);
        if (embree_version().empty())
            EXPECT_EQ(why, "this program was built without Embree");
        else if (stream && embree_version()[0] == '4')
            EXPECT_NE(why.find("build with Embree 3"), std::string::npos) << why;
        else
            EXPECT_EQ(why, "");
    }
}

}  // namespace
}  // namespace ctpbench
