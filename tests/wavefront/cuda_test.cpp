// What holds of the CUDA backend on a device: hits are the CPU's bit for bit, images are the same whatever
// the strategy and the way of launching, and they are the CPU's but for noise. Skipped where there is no
// device.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "backends/cuda.h"
#include "config/cells.h"
#include "support.h"
#include "wavefront/cpu_tracer.h"
#include "wavefront/cuda_workload.h"
#include "wavefront/device_demand.h"
#include "wavefront/frames.h"
#include "wavefront/methods.h"
#include "wavefront/motley.h"

namespace ctpbench {
namespace {

constexpr std::uint32_t kKeys = Materials::size + 1;

class Cuda : public testing::Test {
protected:
    void SetUp() override {
        if (const std::string why = cuda_obstacle(0); !why.empty()) GTEST_SKIP() << why;
        use_cuda_device(0);
    }
};

Batch batch_of(const Scene& scene, std::uint32_t count) {
    Batch batch;
    batch.active = count;
    batch.rays.resize(count);
    const Box box = scene_bounds(scene);
    test::Random random(5);
    for (std::uint32_t i = 0; i < count; ++i) {
        Vec3 d = random.direction();
        if (i % 4 == 2) d[i % 3] = 0.0f;
        const Vec3 origin =
            box.center() + (i % 2 == 0 ? 1.0f : 3.0f) * (box.extent() * random.point(-0.5f, 0.5f));
        batch.rays.view().store(i, {origin, d, i % 32 == 0 ? 0.3f * length(box.extent()) : test::kInfinity});
        batch.index.push_back(count - 1 - i);
    }
    return batch;
}

TEST_F(Cuda, HitsAreTheCpusBitForBit) {
    for (const auto& [triangles, spheres] : {std::pair{600u, 200u}, {600u, 0u}, {0u, 600u}, {1u, 1u}})
        for (const float scale : {1.0f, 1e-6f, 1e6f}) {
            const Scene scene = test::soup(triangles, spheres, 17, scale, {0, 0, 3 * scale});
            test::Stage stage(scene, 2);
            std::vector<Batch> batches{batch_of(scene, 20001)};
            Batch& batch = batches[0];
            const float extent = stage.view.geometry().extent;
            const std::uint64_t expected =
                CpuTracer(stage.backend, *stage.intersector, extent).trace(batch, true).hash;
            const auto workload = make_cuda_workload(stage.scenes, batches, kKeys);
            for (const StrategyInfo& strategy : intersect_strategies())
                for (const auto& [carry_t, types] :
                     {std::pair{true, kAllTypes}, {false, kAllTypes}, {true, kTypesOfScene}}) {
                    const auto tracer = workload->tracer(strategy.name, "watertight", types);
                    const BatchTracer::Traced traced = tracer->trace(batch, carry_t);
                    EXPECT_EQ(traced.hash, expected) << strategy.name << ", carry_t " << carry_t << ", scale "
                                                     << scale << ", types " << types;
                    EXPECT_GT(traced.seconds, 0.0);
                    EXPECT_EQ(tracer->hits().hash(), expected) << "what comes back is what was compared";
                }
        }
}

// Every test of geometry is IEEE operations alone, and no ray here is in the plane of a box's face, where
// minima of the plain box test differ.
TEST_F(Cuda, HitsOfAllMethodsAreTheCpusBitForBit) {
    const Scene scene = test::soup(600, 200, 17);
    test::Stage stage(scene, 2);
    std::vector<Batch> batches{batch_of(scene, 20001)};
    batches.push_back(batches[0]);
    Batch &batch = batches[0], &leaving = batches[1];  // each ray leaves out what it would hit
    const float extent = stage.view.geometry().extent;
    CpuTracer first(stage.backend, *stage.intersector, extent);
    first.trace(batch, true);
    for (std::uint32_t i = 0; i < batch.rays.size(); ++i)
        leaving.excluded.push_back(first.hits().view().primitive[i]);
    const auto workload = make_cuda_workload(stage.scenes, batches, kKeys);
    std::size_t compared = 0;
    const auto compare = [&](const std::string& strategy, const std::string& key) {
        const auto intersector = make_intersector(strategy, key, stage.scenes.layout(kAllTypes));
        CpuTracer cpu(stage.backend, *intersector, extent);
        for (Batch* b : {&batch, &leaving})
            EXPECT_EQ(workload->tracer(strategy, key, kAllTypes)->trace(*b, true).hash,
                      cpu.trace(*b, true).hash)
                << strategy << ", " << key << ", leaving out " << !b->excluded.empty();
        ++compared;
    };
    for (const StrategyInfo& strategy : intersect_strategies())
        for (const MethodsInfo& m : method_bundles()) compare(strategy.name, m.name);
    for (const std::string& triangle : triangle_tests())
        for (const std::string& sphere : sphere_tests())
            for (const std::string& box : box_tests())
                if (methods_obstacle("ctp", "watertight", triangle, sphere, box, of_bundle).empty())
                    compare("ctp", intersect_methods("watertight", triangle, sphere, box, of_bundle));
    compare("ctp", intersect_methods("watertight", of_bundle, of_bundle, of_bundle, "exclude_id"));
    EXPECT_EQ(compared, intersect_strategies().size() * method_bundles().size() + 19 + 1);
}

TEST_F(Cuda, YardstickAgreesAlmostEverywhere) {
    const Scene scene = test::soup(3000, 0, 17);
    test::Stage stage(scene, 2);
    std::vector<Batch> batches{batch_of(scene, 20001)};
    Batch& batch = batches[0];
    CpuTracer cpu(stage.backend, *stage.intersector, stage.view.geometry().extent);
    cpu.trace(batch, true);
    const auto workload = make_cuda_workload(stage.scenes, batches, kKeys);
    const auto tracer = workload->tracer(kCudaYardstick, "own", own_way);
    tracer->trace(batch, true);
    int different = 0;
    for (std::uint32_t i = 0; i < batch.rays.size(); ++i)
        different += tracer->hits().view().primitive[i] != cpu.hits().view().primitive[i];
    EXPECT_LT(different, 100);
}

const FrameSettings kSettings{131, 67, 6, 9};

TEST_F(Cuda, ImagesAreTheSameBitForBitAndTheCpusButForNoise) {
    const Scene scene = test::motley();
    test::Stage stage(scene, 2);
    std::vector<Batch> none;
    const auto workload = make_cuda_workload(stage.scenes, none, kKeys);
    constexpr std::uint32_t samples = 16;
    std::uint64_t expected = 0;
    std::vector<std::uint32_t> paths, dropped;
    ImageStorage image;
    for (const std::string& shade : shade_strategies())
        for (const CudaLaunch launch : {CudaLaunch::isolated, CudaLaunch::concurrent, CudaLaunch::graph}) {
            const auto pipeline = workload->pipeline("typed_leaves", "watertight", kAllTypes, shade, launch,
                                                     test::kMotleyCamera, kSettings);
            image = {};
            std::vector<std::uint32_t> its_paths, its_dropped;
            for (std::uint32_t s = 0; s < samples; ++s)
                for (const StageTime& stage_time : pipeline->frame(true, s, image, {})) {
                    EXPECT_GE(stage_time.start, 0.0);
                    if (std::string(stage_time.kernel) != "shade") continue;
                    its_paths.push_back(stage_time.rays), its_dropped.push_back(stage_time.dropped);
                }
            if (expected == 0) expected = image.hash(), paths = its_paths, dropped = its_dropped;
            EXPECT_EQ(image.hash(), expected) << shade << ", launch " << static_cast<int>(launch);
            EXPECT_EQ(its_paths, paths) << shade;
            EXPECT_EQ(its_dropped, dropped) << shade;
        }

    // Sines and powers differ in their last bits, so a path or two in a thousand goes another way.
    const test::Frames cpu = test::render(stage, test::kMotleyCamera, kSettings, samples, "ctp");
    double sum = 0.0, cpu_sum = 0.0, worst = 0.0;
    std::size_t differing = 0;
    for (std::size_t i = 0; i < image.size(); ++i) {
        const double a = image.at(i).y, b = cpu.image.at(i).y;
        sum += a, cpu_sum += b, worst = std::max(worst, std::fabs(a - b));
        differing += std::fabs(a - b) > 1e-4 * (1.0 + b);
    }
    EXPECT_NEAR(sum / cpu_sum, 1.0, 0.003);
    EXPECT_LT(differing, image.size() / 20) << "largest difference " << worst;
}

// Whatever the offset, and with roulette, all strategies show the same image; it is the CPU's but for noise.
TEST_F(Cuda, ImagesAreTheSameWithEveryOffsetAndWithRoulette) {
    const Scene scene = test::motley();
    test::Stage stage(scene, 2), excluding(scene, 2, "ctp", "watertight+exclude_id");
    std::vector<Batch> none;
    const auto workload = make_cuda_workload(stage.scenes, none, kKeys);
    constexpr std::uint32_t samples = 16;
    for (const std::string& offset : offsets())
        for (const bool roulette : {false, true}) {
            FrameSettings settings = kSettings;
            if (roulette) settings.roulette_from = 2;
            const std::string key = intersect_methods("watertight", of_bundle, of_bundle, of_bundle, offset);
            std::uint64_t expected = 0;
            ImageStorage image;
            for (const std::string& shade : shade_strategies()) {
                const auto pipeline = workload->pipeline("ctp", key, kAllTypes, shade, CudaLaunch::concurrent,
                                                         test::kMotleyCamera, settings, offset);
                image = {};
                for (std::uint32_t s = 0; s < samples; ++s) pipeline->frame(true, s, image, {});
                if (expected == 0) expected = image.hash();
                EXPECT_EQ(image.hash(), expected) << offset << ", " << shade << ", roulette " << roulette;
            }
            const test::Frames cpu = test::render(offset == "exclude_id" ? excluding : stage,
                                                  test::kMotleyCamera, settings, samples, "ctp", {}, offset);
            double sum = 0.0, cpu_sum = 0.0;
            for (std::size_t i = 0; i < image.size(); ++i) sum += image.at(i).y, cpu_sum += cpu.image.at(i).y;
            EXPECT_NEAR(sum / cpu_sum, 1.0, 0.01) << offset << ", roulette " << roulette;
        }
}

// A frame that is watched bounce by bounce shows the same rays and hits as every other strategy's.
TEST_F(Cuda, BouncesShowWhatWasHit) {
    const Scene scene = test::motley();
    test::Stage stage(scene, 2);
    std::vector<Batch> none;
    const auto workload = make_cuda_workload(stage.scenes, none, kKeys);
    std::vector<std::uint64_t> expected;
    for (const char* shade : {"ctp", "sort", "queues"}) {
        std::vector<std::uint64_t> hashes;
        ImageStorage image;
        workload
            ->pipeline("ctp", "watertight", kAllTypes, shade, CudaLaunch::concurrent, test::kMotleyCamera,
                       kSettings)
            ->frame(true, 0, image, [&](const BounceView& view) {
                std::vector<std::uint32_t> slots = view.slots;
                std::sort(slots.begin(), slots.end());
                Batch batch = record_batch(view.bounce, view.rays, slots, 0);
                hashes.push_back(record_hits(batch, view.hits).hash());
                const std::uint64_t cpu =
                    CpuTracer(stage.backend, *stage.intersector, stage.view.geometry().extent)
                        .trace(batch, true)
                        .hash;
                EXPECT_EQ(hashes.back(), cpu) << shade << ", bounce " << view.bounce;
            });
        if (expected.empty()) expected = hashes;
        EXPECT_EQ(hashes, expected) << shade;
        EXPECT_EQ(hashes.size(), 7u);
    }
}

// Kernels that are compiled for the scene's types alone, or for synthetic ones, show what the CPU shows with
// the same types; whatever the strategy, the same image.
TEST_F(Cuda, ImagesAreTheSameWithWhateverTypes) {
    const Scene motley = test::motley(), soup = test::soup(600, 0, 17);
    const auto show = [&](const Scene& scene, const std::string& types, std::uint32_t keys) {
        test::Stage stage(scene, 2, "ctp", "watertight", types);
        std::vector<Batch> none;
        const auto workload = make_cuda_workload(stage.scenes, none, keys);
        std::uint64_t expected = 0;
        ImageStorage image;
        for (const std::string& shade : shade_strategies()) {
            const auto pipeline = workload->pipeline("restart", "watertight", types, shade,
                                                     CudaLaunch::concurrent, test::kMotleyCamera, kSettings);
            image = {};
            for (std::uint32_t s = 0; s < 4; ++s) pipeline->frame(true, s, image, {});
            if (expected == 0) expected = image.hash();
            EXPECT_EQ(image.hash(), expected) << types << ", " << shade;
        }
        const test::Frames cpu = test::render(stage, test::kMotleyCamera, kSettings, 4);
        double sum = 0.0, cpu_sum = 0.0;
        for (std::size_t i = 0; i < image.size(); ++i) sum += image.at(i).y, cpu_sum += cpu.image.at(i).y;
        EXPECT_NEAR(sum / cpu_sum, 1.0, 0.01) << types;
    };
    show(motley, kTypesOfScene, kKeys);
    show(soup, kTypesOfScene, 2);
    for (const char* types : {"synthetic_1", "synthetic_8", "synthetic_8_using_7", "synthetic_32"})
        show(soup, types, kMaxShadeKeys);
}

// What is counted before a run is what the run then holds, with every contender in the workload.
TEST_F(Cuda, MemoryIsWhatWasCounted) {
    const Scene scene = test::motley();
    test::Stage stage(scene, 2);
    std::vector<Batch> batches{batch_of(scene, 20001), batch_of(scene, 777)};
    DeviceDemand demand;
    const auto workload = make_cuda_workload(stage.scenes, batches, kKeys);
    const auto same = [&](const std::string& after) {
        EXPECT_EQ(workload->bytes(), bytes_demanded(demand, stage.scenes, batches)) << after;
    };
    same("batches");
    const auto trace = [&](const std::string& strategy, const std::string& methods) {
        const std::string types = strategy == kCudaYardstick ? own_way : kTypesOfScene;
        const auto tracer = workload->tracer(strategy, methods, types);
        for (Batch& batch : batches) tracer->trace(batch, true);
        demand.intersectors.insert({strategy, methods, types});
        same(strategy + " " + methods);
    };
    for (const StrategyInfo& s : intersect_strategies())
        for (const MethodsInfo& m : method_bundles()) trace(s.name, m.name), trace(s.name, m.name);
    trace(kCudaYardstick, "own");
    demand.frames = kSettings;
    demand.intersectors.insert({"ctp", "watertight", kAllTypes});
    ImageStorage image;
    std::vector<std::unique_ptr<FramePipeline>> pipelines;
    for (const std::string& shade : shade_strategies()) {
        pipelines.push_back(workload->pipeline("ctp", "watertight", kAllTypes, shade, CudaLaunch::graph,
                                               test::kMotleyCamera, kSettings));
        pipelines.back()->frame(true, 0, image, {});
        demand.shaders.push_back({shade, kAllTypes, WaechterBinder::name});
        same("shade " + shade);
    }
    const CudaMemory memory = cuda_memory();
    EXPECT_GT(memory.free, memory.beside) << "this small scene leaves room";
    EXPECT_GT(memory.total, memory.free + workload->bytes());
}

}  // namespace
}  // namespace ctpbench
