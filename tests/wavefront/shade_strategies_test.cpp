// The shade stage's invariant: the image is a function of scene, seed and samples alone. Every shade
// strategy, whatever it does to the order of its paths, and any number of threads give it bit for bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "support.h"
#include "wavefront/frames.h"
#include "wavefront/motley.h"

namespace ctpbench {
namespace {

using test::motley;

const Camera kCamera = test::kMotleyCamera;
const FrameSettings kSettings{101, 67, 6, 9};

TEST(ShadeStrategies, GiveTheSameImageBitForBit) {
    const Scene scene = motley();
    std::uint64_t expected = 0;
    for (const int threads : {1, 2})
        for (const char* intersect : {"ctp", "restart", "typed_leaves"}) {
            test::Stage stage(scene, threads, intersect);
            for (const std::string& shade : shade_strategies()) {
                const test::Frames frames = test::render(stage, kCamera, kSettings, 3, shade);
                if (expected == 0) expected = frames.image.hash();
                EXPECT_EQ(frames.image.hash(), expected)
                    << shade << " after " << intersect << ", " << threads << " threads";
            }
        }
}

TEST(ShadeStrategies, CountTheSamePathsAndDroppedSamples) {
    const Scene scene = motley();
    test::Stage stage(scene, 2);
    std::vector<std::uint32_t> paths, dropped;
    for (const std::string& shade : shade_strategies()) {
        std::vector<std::uint32_t> its_paths, its_dropped;
        for (const StageTime& s : test::render(stage, kCamera, kSettings, 1, shade).stages) {
            if (std::string(s.kernel) != "shade") continue;
            its_paths.push_back(s.rays), its_dropped.push_back(s.dropped);
        }
        if (paths.empty()) paths = its_paths, dropped = its_dropped;
        EXPECT_EQ(its_paths, paths) << shade;
        EXPECT_EQ(its_dropped, dropped) << shade;
    }
    EXPECT_EQ(paths.size(), 7u);
    EXPECT_GT(*std::max_element(dropped.begin(), dropped.end()), 0u) << "the scene has glossy grazing angles";
}

// The scene is worth the test: each type is hit, textures matter, and so do their holes.
TEST(ShadeStrategies, AreTestedOnAllThatMaterialsDo) {
    const Scene scene = motley();
    test::Stage stage(scene, 2);
    std::map<std::uint32_t, int> seen;
    const std::uint64_t image =
        test::render(stage, kCamera, kSettings, 1, "ctp", [&](const BounceView& view) {
            for (const std::uint32_t slot : view.slots) {
                const std::uint32_t primitive = view.hits.primitive[slot];
                const MaterialWords words = stage.materials.words();
                ++seen[primitive == kNoPrimitive ? words.miss_key() : words.of(primitive).type()];
            }
        }).image.hash();
    for (std::uint32_t key = 0; key <= Materials::size; ++key) EXPECT_GT(seen[key], 100) << key;

    const auto image_with = [&](auto change) {
        Scene other = motley();
        change(other);
        test::Stage other_stage(other, 2);
        return test::render(other_stage, kCamera, kSettings).image.hash();
    };
    EXPECT_NE(image, image_with([](Scene& s) { s.texels[1].g /= 2; }));
    EXPECT_NE(image, image_with([](Scene& s) {
                  for (Texel& t : s.texels) t.a = 65535;
              }));
    EXPECT_EQ(image, image_with([](Scene&) {}));
}

}  // namespace
}  // namespace ctpbench
