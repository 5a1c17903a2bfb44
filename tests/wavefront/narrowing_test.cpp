// Kernels that are compiled for some types only find and show what those for all types do, bit for bit: every
// subset of primitives, every subset of materials, with and without textures.
#include <gtest/gtest.h>

#include <bit>

#include "kernels/registry.h"
#include "support.h"
#include "wavefront/frames.h"
#include "wavefront/methods.h"
#include "wavefront/motley.h"

namespace ctpbench {
namespace {

const Camera kCamera = test::kMotleyCamera;
const FrameSettings kSettings{67, 45, 5, 9};

// The motley scene with materials of these types alone, and without textures or with.
Scene motley_of(std::uint32_t mask, bool textured) {
    Scene scene = test::motley();
    std::vector<std::uint32_t> types;
    for (std::uint32_t type = 0; type < Materials::size; ++type)
        if (mask >> type & 1u) types.push_back(type);
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        MaterialDescription& look = scene.materials[m].look;
        if (!(mask >> look.type & 1u)) look.type = types[m % types.size()];
        if (!textured || !(kTexturable >> look.type & 1u)) look.texture = {};
    }
    return scene;
}

std::string name_of(std::uint32_t mask, bool textured) {
    std::string name;
    for_each_type(Materials{}, [&](auto tag) {
        using T = typename decltype(tag)::type;
        if (mask >> material_type<T> & 1u) name += std::string(T::name) + " ";
    });
    return name + (textured ? "with textures" : "");
}

TEST(Narrowing, EveryListOfMaterialsShowsWhatAllDo) {
    int lists = 0;
    for (std::uint32_t mask = 1; mask < 1u << Materials::size; ++mask)
        for (const bool textured : {false, true}) {
            if (textured && (mask & kTexturable) == 0) continue;
            const Scene scene = motley_of(mask, textured);
            const SceneNeeds needs = needs_of(scene);
            ASSERT_EQ(needs.materials, mask) << "the scene has them all";
            ASSERT_EQ(needs.textured, textured);
            ++lists;
            test::Stage stage(scene, 2), narrow(scene, 2, "ctp", Watertight::name, kTypesOfScene);
            const MaterialInput input = narrow.materials.input();
            EXPECT_EQ(input.types, (MaterialTypes{mask, textured}));
            EXPECT_EQ(narrow.materials.types(), static_cast<std::uint32_t>(std::popcount(mask)));
            const std::uint64_t expected = test::render(stage, kCamera, kSettings, 2).image.hash();
            for (const std::string& shade : shade_strategies())
                EXPECT_EQ(test::render(narrow, kCamera, kSettings, 2, shade).image.hash(), expected)
                    << shade << ", " << name_of(mask, textured);
        }
    // Every subset without textures, and with them those that hold a type which looks at one.
    const int plain = 1 << std::popcount(whole_mask<Materials> & ~kTexturable);
    EXPECT_EQ(lists, (1 << Materials::size) - 1 + (1 << Materials::size) - plain);
    EXPECT_TRUE(kTexturable >> material_type<Matte> & kTexturable >> material_type<Plastic> & 1u);
    EXPECT_FALSE((kTexturable >> material_type<Mirror> | kTexturable >> material_type<Emissive>)&1u);
}

// With other offsets kernels have all types, whatever is asked for.
TEST(Narrowing, OfMaterialsIsForTheDefaultOffset) {
    const Scene scene = motley_of(1u << material_type<Matte>, false);
    test::Stage stage(scene, 2, "ctp", Watertight::name, kTypesOfScene);
    std::string all;
    for_each_type(Materials{}, [&](auto tag) {
        all += (all.empty() ? "" : "+") + std::string(decltype(tag)::type::name);
    });
    for (const std::string& offset : offsets()) {
        const MaterialInput input = stage.scenes.materials(kTypesOfScene, offset).input();
        EXPECT_EQ(input.types == MaterialTypes{}, offset != WaechterBinder::name) << offset;
        EXPECT_EQ(material_list(kTypesOfScene, offset, needs_of(scene)),
                  offset == WaechterBinder::name ? "matte" : all + ", textured");
    }
}

struct Mixture {
    const char* name;
    std::uint32_t triangles, spheres;
};

TEST(Narrowing, EveryListOfPrimitivesFindsWhatAllDo) {
    for (const Mixture& p :
         {Mixture{"triangle", 600, 0}, {"sphere", 0, 600}, {"triangle+sphere", 600, 200}}) {
        const Scene scene = test::soup(p.triangles, p.spheres, 17);
        test::Stage stage(scene, 2);
        EXPECT_EQ(primitive_list(kTypesOfScene, needs_of(scene)), p.name);
        EXPECT_EQ(primitive_list(kAllTypes, needs_of(scene)), "triangle+sphere");
        const LayoutInput &all = stage.scenes.layout(kAllTypes), &narrow = stage.scenes.layout(kTypesOfScene);
        ASSERT_EQ(narrow.types == kAllPrimitives, p.triangles > 0 && p.spheres > 0);
        for (const StrategyInfo& strategy : intersect_strategies())
            for (const MethodsInfo& methods : method_bundles()) {
                stage.intersector = make_intersector(strategy.name, methods.name, all);
                const std::size_t bytes = stage.intersector->bytes();
                const std::uint64_t expected = test::render(stage, kCamera, kSettings).image.hash();
                stage.intersector = make_intersector(strategy.name, methods.name, narrow);
                EXPECT_EQ(test::render(stage, kCamera, kSettings).image.hash(), expected)
                    << strategy.name << ", " << methods.name << ", " << p.name;
                EXPECT_LE(stage.intersector->bytes(), bytes) << strategy.name << ", " << p.name;
            }
    }
}

// One type needs no tag, no padding and no branch: the element is that type, and all strategies that hold
// values traverse the very same thing.
TEST(Narrowing, OneTypeIsNothingButThatType) {
    using Alone = TypeList<Triangle<Watertight>>;
    using View = TypedTree<Watertight, Triangle<Watertight>>;
    EXPECT_TRUE((std::is_same_v<Ctp<Watertight, Alone>::Element, Triangle<Watertight>>));
    EXPECT_TRUE((std::is_same_v<StdVariant<Watertight, Alone>::Element, Triangle<Watertight>>));
    const HostPlace place;
    EXPECT_TRUE((std::is_same_v<decltype(std::declval<Ctp<Watertight, Alone>::Layout>().view(place)), View>));
    EXPECT_TRUE(
        (std::is_same_v<decltype(std::declval<TypedLeaves<Watertight, Alone>::Layout>().view(place)), View>));
    EXPECT_GT(sizeof(Ctp<Watertight>::Element), sizeof(Triangle<Watertight>));

    using OnlyMatte = Filtered<UntexturedMaterials, 1u << material_type<Matte>>;
    EXPECT_EQ(sizeof(ShadeCtp<OnlyMatte>::Element), sizeof(Vec3)) << "a colour";
    EXPECT_LT(sizeof(ShadeCtp<UntexturedMaterials>::Element), sizeof(ShadeCtp<Materials>::Element));
}

}  // namespace
}  // namespace ctpbench
