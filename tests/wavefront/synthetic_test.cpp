// Synthetic types: whatever the list, hits are those of plain triangles, and every strategy shows the same
// image.
#include <gtest/gtest.h>

#include <set>

#include "base/error.h"
#include "support.h"
#include "wavefront/cpu_tracer.h"
#include "wavefront/frames.h"
#include "wavefront/motley.h"

namespace ctpbench {
namespace {

bool is_synthetic(const std::string& types) {
    return type_choice(types).synthetic.any() && types_built(types);
}

Batch rays_of(const Scene& scene, test::Stage& stage) {
    std::vector<Batch> batches;
    test::render(stage, test::kMotleyCamera, {97, 61, 2, 3}, 1, "ctp", [&](const BounceView& view) {
        batches.push_back(record_batch(view.bounce, view.rays, view.slots, 0));
    });
    EXPECT_GT(batches.size(), 2u) << scene.name;
    return batches.back();
}

TEST(SyntheticTypes, HaveTheHitsOfPlainTriangles) {
    const Scene scene = test::soup(20000, 0, 17);
    test::Stage stage(scene, 2);
    Batch batch = rays_of(scene, stage);
    const float extent = stage.view.geometry().extent;
    const std::uint64_t expected =
        CpuTracer(stage.backend, *stage.intersector, extent).trace(batch, true).hash;
    int lists = 0;
    for (const std::string& types : type_choices()) {
        if (!is_synthetic(types)) continue;
        ++lists;
        for (const StrategyInfo& strategy : intersect_strategies())
            for (const bool carry_t : {true, false}) {
                const auto intersector =
                    make_intersector(strategy.name, Watertight::name, stage.scenes.layout(types));
                EXPECT_EQ(CpuTracer(stage.backend, *intersector, extent).trace(batch, carry_t).hash, expected)
                    << types << ", " << strategy.name << ", carry_t " << carry_t;
            }
    }
    EXPECT_EQ(lists, std::size(kBuiltLists) == std::size(kSyntheticLists) ? 19 : 9);
}

TEST(SyntheticTypes, ShowTheSameImageWhateverTheStrategy) {
    const Scene scene = test::soup(20000, 0, 17);
    std::set<std::uint64_t> images;
    for (const std::string& types : type_choices()) {
        if (!is_synthetic(types)) continue;
        test::Stage stage(scene, 2, "ctp", Watertight::name, types);
        const FrameSettings settings{97, 61, 3, 3};
        const std::uint64_t expected = test::render(stage, test::kMotleyCamera, settings, 2).image.hash();
        images.insert(expected);
        for (const std::string& shade : shade_strategies())
            EXPECT_EQ(test::render(stage, test::kMotleyCamera, settings, 2, shade).image.hash(), expected)
                << types << ", " << shade;
    }
    EXPECT_GT(images.size(), std::size(kBuiltLists)) << "types draw random numbers of their own";
}

// What a choice says the scene has is what its trees and materials have.
TEST(SyntheticTypes, AreUsedAsTheChoiceSays) {
    const Scene scene = test::soup(20000, 0, 17);
    test::Stage stage(scene, 2);
    for (const std::string& types : type_choices()) {
        const TypeChoice choice = type_choice(types);
        if (!choice.synthetic.any()) continue;
        std::set<std::uint32_t> in_tree, in_materials, expected;
        const TreeView& tree = stage.scenes.layout(types).mixed;
        for (std::size_t i = 0; i < tree.ref_count; ++i) in_tree.insert(tree.refs[i].type);
        const MaterialTable& table = stage.scenes.materials(types, WaechterBinder::name);
        for (std::uint32_t i = 0; i < scene.mesh.triangles.size(); ++i)
            in_materials.insert(table.words().of(i).type());
        for (std::uint32_t t = 0; t < choice.used; ++t) expected.insert(choice.first_used + t);
        EXPECT_EQ(in_tree, expected) << types;
        EXPECT_EQ(in_materials, expected) << types;
        EXPECT_EQ(table.types(), choice.synthetic.listed);
        EXPECT_LE(choice.first_used + choice.used, choice.synthetic.listed);
    }
}

TEST(SyntheticTypes, OfWhichOneIsLargeMakeVariantsLargeAndNothingElse) {
    const Scene scene = test::soup(5000, 0, 17);
    test::Stage stage(scene, 2);
    const auto bytes = [&](const char* strategy, const char* types) {
        return make_intersector(strategy, Watertight::name, stage.scenes.layout(types))->bytes();
    };
    EXPECT_GT(bytes("ctp", "synthetic_8_large_unused"), 4 * bytes("ctp", "synthetic_8_using_7"));
    EXPECT_EQ(bytes("restart", "synthetic_8_large_unused"), bytes("restart", "synthetic_8_using_7"));
    EXPECT_EQ(bytes("oop", "synthetic_8_large_unused"), bytes("oop", "synthetic_8_using_7"));
    EXPECT_GT(bytes("oop", "synthetic_8_large"), bytes("oop", "synthetic_8_using_7"));
}

TEST(SyntheticTypes, AreTrianglesWithTheDefaultMethods) {
    const Scene scene = test::soup(600, 5, 17);
    test::Stage stage(scene, 2);
    try {
        stage.scenes.layout("synthetic_8");
        FAIL() << "the scene has spheres";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        EXPECT_NE(std::string(error.what()).find("5 spheres"), std::string::npos) << error.what();
    }
    EXPECT_EQ(types_obstacle("synthetic_8", true, 0), "");
    EXPECT_NE(types_obstacle("synthetic_8", false, 0), "");
    EXPECT_NE(types_obstacle("synthetic_8", true, 10), "");
    EXPECT_EQ(types_obstacle("all", false, 10), "");
}

}  // namespace
}  // namespace ctpbench
