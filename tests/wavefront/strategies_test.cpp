// The suite's first invariant: hits are a function of scene and ray alone. Every strategy, tree, pass
// order and number of threads gives what a loop over all primitives gives, bit for bit.
#include <gtest/gtest.h>

#include "kernels/methods/exchanges.h"
#include "support.h"
#include "wavefront/columns.h"
#include "wavefront/forest.h"
#include "wavefront/interleaved/intersector.h"
#include "wavefront/intersector.h"
#include "wavefront/scene_view.h"

namespace ctpbench {
namespace {

using test::kInfinity;
using test::Random;

const std::set<TreeKind> kAllTrees = {TreeKind::mixed, TreeKind::typed_leaves, TreeKind::per_type};

Forest forest_of(CpuBackend& backend, const Scene& scene, const SbvhSettings& settings) {
    return build_forest(backend, scene, kAllTrees, settings, nullptr, [](const std::string&, double) {});
}

// Rays at random, along axes, at vertices and at edges, from inside and outside the scene.
RayStorage adversarial_rays(const Scene& scene, std::uint32_t count, std::uint64_t seed) {
    RayStorage storage;
    storage.resize(count);
    const Box box = scene_bounds(scene);
    Random random(seed);
    const auto somewhere = [&](float spread) {
        const Vec3 e = box.extent();
        return box.center() + spread * (e * random.point(-0.5f, 0.5f));
    };
    for (std::uint32_t i = 0; i < count; ++i) {
        const Vec3 origin = somewhere(i % 2 == 0 ? 1.0f : 3.0f);
        Vec3 d = random.direction();
        const auto triangles = scene.mesh.triangles.size();
        if (triangles > 0 && i % 4 == 1) {
            const TriangleShape t = scene.mesh.triangle(i % triangles);
            d = (i % 8 == 1 ? t.a : t.a + random.uniform(0, 1) * (t.b - t.a)) - origin;
        } else if (i % 4 == 2) {
            d[i % 3] = 0.0f;
        } else if (i % 16 == 3) {
            d = {0, 0, 0};
            d[i % 3] = i % 5 == 0 ? -1.0f : 1.0f;
        }
        storage.view().store(i, {origin, d, i % 32 == 0 ? 0.3f * length(box.extent()) : kInfinity});
    }
    return storage;
}

// Bundles of 64 neighbours that differ little, each around one of the adversarial rays; in some all are the
// same ray.
RayStorage coherent_rays(const Scene& scene, std::uint32_t bundles, std::uint64_t seed) {
    RayStorage leaders = adversarial_rays(scene, bundles, seed), storage;
    storage.resize(bundles * 64);
    Random random(seed + 1);
    const float size = length(scene_bounds(scene).extent());
    for (std::uint32_t b = 0; b < bundles; ++b) {
        const Ray leader = leaders.view().load(b);
        const float spread = b % 5 == 0 ? 0.0f : 0.02f * length(leader.direction);
        for (std::uint32_t i = 0; i < 64; ++i) {
            Ray ray = leader;
            ray.direction = ray.direction + spread * random.point(-1, 1);
            if (b % 3 == 0) ray.origin = ray.origin + (1e-3f * size) * random.point(-1, 1);
            storage.view().store(b * 64 + i, ray);
        }
    }
    return storage;
}

struct Traced {
    HitStorage hits;
    std::uint32_t found = 0, spheres = 0;
};

Traced trace(CpuBackend& backend, const Intersector& intersector, RayStorage& rays,
             const GeometryView& geometry, bool carry_t) {
    Traced traced;
    const auto n = static_cast<std::uint32_t>(rays.size());
    traced.hits.resize(n);
    std::vector<std::uint32_t> index(n);
    for (std::uint32_t i = 0; i < n; ++i) index[i] = n - 1 - i;  // any order will do
    intersector.intersect(backend, {rays.view(), traced.hits.view(), index.data(), n, geometry.extent},
                          carry_t);
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t id = traced.hits.view().primitive[i];
        traced.found += id != kNoPrimitive;
        traced.spheres += id != kNoPrimitive && id >= geometry.first_sphere();
    }
    return traced;
}

template <class Methods>
HitStorage brute_force(RayStorage& rays, const GeometryView& geometry) {
    HitStorage hits;
    hits.resize(rays.size());
    for (std::uint32_t i = 0; i < rays.size(); ++i) {
        const Ray ray = rays.view().load(i);
        const RayContext<Methods> context(ray, geometry.extent);
        Hit hit = no_hit(ray);
        for_each_type(Primitives<Methods>{}, [&](auto tag) {
            using T = typename decltype(tag)::type;
            const bool triangles = std::is_same_v<T, Triangle<Methods>>;
            const std::uint32_t count = triangles ? geometry.triangle_count : geometry.sphere_count;
            for (std::uint32_t p = 0; p < count; ++p) T::make(geometry, p).intersect(context, hit);
        });
        hits.view().store(i, hit);
    }
    return hits;
}

struct Named {
    std::string name;
    std::unique_ptr<Intersector> intersector;
};

// Every strategy with every traversal, on every instruction set that this machine has.
template <class Methods>
std::vector<Named> all_intersectors(CpuBackend& backend, const LayoutInput& input) {
    std::vector<Named> all;
    for (const StrategyInfo& s : intersect_strategies())
        all.push_back({s.name, make_intersector(s.name, Methods::name, input)});
    if (std::is_same_v<Methods, Watertight>)
        for (const std::string& isa : usable_isas())
            for (const StrategyInfo& s : interleaved_strategies())
                all.push_back(
                    {s.name + ", interleaved, " + isa, make_interleaved(backend, s.name, input, isa)});
    return all;
}

template <class Methods>
void expect_all_strategies_give(const Scene& scene, const SceneView& view, RayStorage& rays,
                                bool with_spheres) {
    const std::uint64_t expected = brute_force<Methods>(rays, view.geometry()).hash();
    CpuBackend one(1), two(2);
    for (const BuilderInfo& builder : tree_builders()) {
        const Forest forest = forest_of(two, scene, builder.settings);
        for (const Named& named : all_intersectors<Methods>(two, forest.layout_input(view.geometry()))) {
            for (CpuBackend* backend : {&one, &two})
                for (bool carry_t : {true, false}) {
                    const Traced traced = trace(*backend, *named.intersector, rays, view.geometry(), carry_t);
                    EXPECT_EQ(traced.hits.hash(), expected)
                        << Methods::name << ", " << named.name << ", builder " << builder.name << ", "
                        << backend->threads() << " threads, carry_t " << carry_t;
                    EXPECT_GT(traced.found, 200u);
                    EXPECT_EQ(traced.spheres > 0, with_spheres);
                }
            EXPECT_GT(named.intersector->bytes(), 0u);
        }
    }
}

struct Case {
    const char* name;
    std::uint32_t triangles, spheres;
    float scale;
    Vec3 offset;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class Strategies : public testing::TestWithParam<Case> {};

TEST_P(Strategies, AllGiveWhatALoopOverAllPrimitivesGives) {
    const Case& c = GetParam();
    const Scene scene = test::soup(c.triangles, c.spheres, 17, c.scale, c.offset);
    const SceneView view(scene);
    RayStorage rays = adversarial_rays(scene, 6000, 23);
    // Hits of the float64 bundle depend on the tree for rays in a triangle's plane alone, and none of these
    // is.
    expect_all_strategies_give<Watertight>(scene, view, rays, c.spheres > 0);
    expect_all_strategies_give<Float64Methods>(scene, view, rays, c.spheres > 0);
}

TEST_P(Strategies, GiveTheSameForRaysThatAreAlike) {
    const Case& c = GetParam();
    const Scene scene = test::soup(c.triangles, c.spheres, 17, c.scale, c.offset);
    const SceneView view(scene);
    RayStorage rays = coherent_rays(scene, 100, 23);
    expect_all_strategies_give<Watertight>(scene, view, rays, c.spheres > 0);
}
INSTANTIATE_TEST_SUITE_P(Soups, Strategies,
                         testing::Values(Case{"mixed", 600, 200, 1.0f, {0, 0, 0}},
                                         Case{"triangles_alone", 600, 0, 1.0f, {0, 0, 0}},
                                         Case{"spheres_alone", 0, 600, 1.0f, {0, 0, 0}},
                                         Case{"one_triangle_one_sphere", 1, 1, 1.0f, {0, 0, 0}},
                                         Case{"far_from_the_origin", 600, 200, 1.0f, {1e4f, -2e4f, 3e4f}},
                                         Case{"tiny", 600, 200, 1e-6f, {0, 0, 0}},
                                         Case{"huge", 600, 200, 1e6f, {0, 0, 0}}),
                         [](const auto& param) { return std::string(param.param.name); });

// Tests without a bound on what they report promise less: strategies agree on all but a few rays.
template <class Methods>
void expect_agreement_almost_everywhere() {
    const Scene scene = test::soup(600, 200, 17);
    const SceneView view(scene);
    RayStorage rays = adversarial_rays(scene, 6000, 23);
    HitStorage expected = brute_force<Methods>(rays, view.geometry());
    CpuBackend backend(2);
    const Forest forest = forest_of(backend, scene, SbvhSettings::paper());
    for (const StrategyInfo& strategy : intersect_strategies()) {
        const auto intersector =
            make_intersector(strategy.name, Methods::name, forest.layout_input(view.geometry()));
        Traced traced = trace(backend, *intersector, rays, view.geometry(), true);
        int different = 0;
        for (std::uint32_t i = 0; i < rays.size(); ++i)
            different += traced.hits.view().primitive[i] != expected.view().primitive[i];
        EXPECT_LT(different, 30) << strategy.name;
    }
}

TEST(PaperMethods, AgreeAlmostEverywhere) { expect_agreement_almost_everywhere<PaperMethods>(); }
TEST(FastMethods, AgreeAlmostEverywhere) { expect_agreement_almost_everywhere<FastMethods>(); }

// A sphere test in float64 leaves the rest exact.
TEST(StableSphere64, IsExactWithPaddedBoxes) {
    const Scene scene = test::soup(600, 200, 17);
    const SceneView view(scene);
    RayStorage rays = adversarial_rays(scene, 6000, 23);
    using Methods = Tests<WatertightTriangle, StableSphere64, PaddedBox>;
    CpuBackend backend(2);
    for (const BuilderInfo& builder : tree_builders()) {
        const Forest forest = forest_of(backend, scene, builder.settings);
        const auto intersector =
            make_intersector("ctp", tests_key<Methods>(), forest.layout_input(view.geometry()));
        EXPECT_EQ(trace(backend, *intersector, rays, view.geometry(), true).hits.hash(),
                  brute_force<Methods>(rays, view.geometry()).hash())
            << builder.name;
    }
}

TEST(Ties, CoincidentPrimitivesGoToTheLowestId) {
    Scene scene = test::soup(0, 0, 1);
    scene.mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
    for (int i = 0; i < 40; ++i) scene.mesh.triangles.push_back({0, 1, 2}), scene.mesh.material.push_back(0);
    for (int i = 0; i < 40; ++i) scene.spheres.push_back({{0, 0, 5}, 1});
    const SceneView view(scene);
    CpuBackend backend(1);
    RayStorage rays;
    rays.resize(66);  // two bundles of rays that are alike, and one of each alone
    for (std::uint32_t i = 0; i < 66; ++i) {
        const bool front = i < 32 || i == 64;
        const float x = 0.001f * static_cast<float>(i % 32);
        rays.view().store(i, {{x, 0, front ? -3.0f : 9.0f}, {0, 0, front ? 1.0f : -1.0f}, kInfinity});
    }
    for (const BuilderInfo& builder : tree_builders()) {
        const Forest forest = forest_of(backend, scene, builder.settings);
        for (const Named& named :
             all_intersectors<Watertight>(backend, forest.layout_input(view.geometry()))) {
            Traced traced = trace(backend, *named.intersector, rays, view.geometry(), true);
            for (std::uint32_t i = 0; i < 66; ++i)
                EXPECT_EQ(traced.hits.view().primitive[i], i < 32 || i == 64 ? 0u : 40u) << named.name << i;
        }
    }
}

TEST(Intersectors, OfNothingMissEverything) {
    const Scene scene = test::soup(0, 0, 1);
    const SceneView view(scene);
    CpuBackend backend(2);
    RayStorage rays;
    rays.resize(3000);
    for (std::uint32_t i = 0; i < 3000; ++i) rays.view().store(i, {{0, 0, -3}, {0, 0, 1}, 5.0f});
    const Forest forest = forest_of(backend, scene, SbvhSettings::quality());
    for (const Named& named : all_intersectors<Watertight>(backend, forest.layout_input(view.geometry()))) {
        Traced traced = trace(backend, *named.intersector, rays, view.geometry(), true);
        EXPECT_EQ(traced.found, 0u) << named.name;
        EXPECT_EQ(traced.hits.view().t[2999], 5.0f) << named.name;
    }
}

// What the stage leaves behind beside hits, and which rays it takes: the same whatever the traversal.
TEST(Intersectors, KeepToSegmentsAndRecordKeysInOrder) {
    const Scene scene = test::soup(600, 200, 17);
    const SceneView view(scene);
    CpuBackend backend(2);
    constexpr std::uint32_t kSegments = 11, kRays = kSegments * kSegment;
    RayStorage rays = adversarial_rays(scene, kRays, 23);
    std::vector<std::uint32_t> index(kRays), counts(kSegments);
    for (std::uint32_t i = 0; i < kRays; ++i) index[i] = i ^ 1u;
    for (std::uint32_t s = 0; s < kSegments; ++s) counts[s] = s % 3 == 1 ? 0 : kSegment - 97 * s;
    counts[2] = 1;
    std::vector<MaterialWord> of_triangle;
    for (std::uint32_t i = 0; i < 600; ++i) of_triangle.push_back(MaterialWord::make(i % 3, i));
    const MaterialWords words{of_triangle.data(), 600, MaterialWord::make(3, 0), 4};
    struct Left {
        HitStorage hits;
        std::vector<std::uint8_t> keys = std::vector<std::uint8_t>(kRays, 77);
        std::vector<std::uint32_t> slots = std::vector<std::uint32_t>(5 * kRays, 0);
        std::vector<std::uint32_t> lengths = std::vector<std::uint32_t>(kSegments * segment_stride(5), 0);
        bool operator==(const Left& o) const {
            return keys == o.keys && slots == o.slots && lengths == o.lengths;
        }
    };
    const auto run = [&](const Intersector& intersector, bool segmented, bool queues) {
        Left left;
        left.hits.resize(kRays);
        for (std::uint32_t i = 0; i < kRays; ++i) left.hits.view().store(i, {-1.0f, 5, 0.25f, 0.5f});
        IntersectBuffers io{rays.view(), left.hits.view(), index.data(), kRays, view.geometry().extent};
        io.keys.words = words;
        if (queues)
            io.keys.queues = {left.slots.data(), left.lengths.data(), kRays, segment_stride(5)};
        else
            io.keys.keys = left.keys.data();
        if (segmented) io.segment_counts = counts.data(), io.segments = kSegments;
        intersector.intersect(backend, io, true);
        return left;
    };
    const Forest forest = forest_of(backend, scene, SbvhSettings::quality());
    const std::vector<Named> all =
        all_intersectors<Watertight>(backend, forest.layout_input(view.geometry()));
    for (const bool segmented : {false, true})
        for (const bool queues : {false, true}) {
            if (queues && !segmented) continue;  // queues are in segments
            const Left expected = run(*all[0].intersector, segmented, queues);
            for (const Named& named : all) {
                const Left left = run(*named.intersector, segmented, queues);
                EXPECT_EQ(left.hits.hash(), expected.hits.hash()) << named.name << segmented << queues;
                EXPECT_TRUE(left == expected) << named.name << segmented << queues;
            }
        }
}

}  // namespace
}  // namespace ctpbench
