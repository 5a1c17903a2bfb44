// What a device would have to hold is counted by the code that lays it out there.
// tests/wavefront/cuda_test.cpp compares the count with what is allocated, where there is a device.
#include "wavefront/device_demand.h"
#include "wavefront/methods.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "kernels/registry.h"
#include "wavefront/counting_place.h"
#include "wavefront/motley.h"

namespace ctpbench {
namespace {

struct Odd {
    char bytes[20];
};

TEST(CountingPlace, CountsWhatStaysAndTheMostThatIsLent) {
    const CountingPlace place;
    const Odd array[5] = {};
    place(array, 5);
    EXPECT_EQ(place.bytes(), 5u * 20);
    place.elements(Array<Odd>(7));
    EXPECT_EQ(place.bytes(), 5u * 20 + 7 * 32) << "an element lies in a slot of 16-byte words";
    place.reserve<float>(3);
    place.lend(array, 5), place.lend(array, 2);
    EXPECT_EQ(place.bytes(), 5u * 20 + 7 * 32 + 12 + 100);
}

class Demand : public testing::Test {
protected:
    std::size_t bytes(const DeviceDemand& demand) { return bytes_demanded(demand, stage.scenes, batches); }

    const Scene scene = test::motley();
    test::Stage stage{scene, 2};
    const LayoutInput layout = stage.forest.layout_input(stage.view.geometry());
    std::vector<Batch> batches;
};

TEST_F(Demand, OfALayoutIsItsNodesAndElements) {
    const std::size_t nothing = bytes({});
    EXPECT_EQ(bytes({{{"ctp", "watertight", "scene"}}, {}, {}}) - nothing,
              layout.mixed.node_count * sizeof(BvhNode) +
                  layout.mixed.ref_count * sizeof(Slot<Ctp<Watertight>::Element>));
    // Objects by scene order, a pointer per leaf entry; the largest of what is lent while they are made.
    const std::size_t objects = 3000 * sizeof(PrimitiveObject<Watertight, Triangle<Watertight>>) +
                                60 * sizeof(PrimitiveObject<Watertight, Sphere<Watertight>>);
    const std::size_t lent =
        std::max(layout.mixed.ref_count * sizeof(PrimitiveRef), 3000 * sizeof(Triangle<Watertight>));
    EXPECT_EQ(
        bytes({{{"oop", "watertight", "scene"}}, {}, {}}) - nothing,
        layout.mixed.node_count * sizeof(BvhNode) + layout.mixed.ref_count * sizeof(void*) + objects + lent);
}

TEST_F(Demand, OfAllIsTheSum) {
    const std::size_t nothing = bytes({});
    DeviceDemand all;
    std::size_t sum = nothing;
    for (const StrategyInfo& s : intersect_strategies())
        for (const MethodsInfo& m : method_bundles()) {
            if (s.name.starts_with("oop")) continue;  // what they are lent is not added up
            const std::array<std::string, 3> both{s.name, m.name, "scene"};
            all.intersectors.insert(both);
            sum += bytes({{both}, {}, {}}) - nothing;
        }
    all.intersectors.insert({"while_while", "own", "own"});
    sum += bytes({{{"while_while", "own", "own"}}, {}, {}}) - nothing;
    // Queues take room for each key that any shader tells apart, so frames and shaders go together.
    all.frames = FrameSettings{131, 67, 6, 9};
    all.shaders = {{"ctp", "scene", "waechter_binder"}, {"sort", "all", "waechter_binder"}};
    sum += bytes({{}, all.shaders, all.frames}) - nothing;
    EXPECT_EQ(bytes(all), sum);
}

TEST_F(Demand, OfShadersIsTheirMaterialsAndOneColumnOfWordsForEachList) {
    const auto of = [&](const std::vector<DeviceDemand::Shader>& shaders) {
        return bytes({{}, shaders, {}}) - bytes({});
    };
    const DeviceDemand::Shader ctp{"ctp", "all", "waechter_binder"}, sort{"sort", "all", "waechter_binder"};
    const std::size_t words = scene.mesh.triangles.size() * sizeof(MaterialWord);
    EXPECT_EQ(of({ctp}), words + scene.materials.size() * sizeof(ShadeCtp<Materials>::Element));
    EXPECT_EQ(of({ctp, sort}), of({ctp}) + of({sort}) - words);
    // The spheres' list of keys is the longest: five of them.
    const FrameSettings frame{64, 64, 6, 9};
    const auto pixel = [&](const std::string& types) {
        return bytes({{}, {{"ctp", types, "waechter_binder"}}, frame}) -
               of({{"ctp", types, "waechter_binder"}});
    };
    EXPECT_GE(pixel("all"), pixel("scene"));
}

TEST_F(Demand, GrowsWithPixelsAndRays) {
    const auto frame = [&](std::uint32_t width) { return bytes({{}, {}, FrameSettings{width, 64, 6, 9}}); };
    const std::size_t pixel = (frame(128) - frame(64)) / (64 * 64);
    EXPECT_GE(pixel, sizeof(Ray) + sizeof(Hit)) << "of rays, hits, paths, indices and queues";
    EXPECT_LT(pixel, 200u);

    const std::size_t nothing = bytes({});
    for (const std::uint32_t n : {1000u, 400u}) {
        batches.emplace_back();
        batches.back().rays.resize(n), batches.back().index.resize(n);
    }
    // Rays, an index and the hits found first of each; and room for the hits of the longest.
    EXPECT_EQ(bytes({}) - nothing, 1400u * (7 * 4 + 4 + 16) + 1000u * 16);
}

TEST(DeviceMemory, ErrorHasBytesNeededAndFree) {
    const CudaMemory memory{5000, 9000, 1000};
    EXPECT_NO_THROW(require_device_memory("conference/1000", 4000, memory));
    try {
        require_device_memory("conference/1000", 4001, memory);
        FAIL() << "it does not fit";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::no_backend);
        const std::string text = error.what();
        for (const char* part : {"backend cuda: error:", "conference/1000", "4001 bytes needed",
                                 "1000 for stacks", "5000 of 9000 free", "batch_rays", "--backend cpu"})
            EXPECT_NE(text.find(part), std::string::npos) << part << " is not in: " << text;
    }
}

}  // namespace
}  // namespace ctpbench
