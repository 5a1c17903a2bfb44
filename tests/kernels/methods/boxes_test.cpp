// Box tests one box at a time. What they lose of a whole mesh is in tests/wavefront/box_leaks_test.cpp.
#include <gtest/gtest.h>

#include "kernels/methods/lists.h"
#include "support.h"

namespace ctpbench {
namespace {

using test::kInfinity;
using test::Random;

BvhNode node_of(const Box& box) {
    BvhNode node{};
    node.set_box(box);
    return node;
}

// Flat boxes, rays along their planes, origins on grid planes, zero components: the box of a point that
// the ray passes is never missed, and never entered after it.
TEST(PaddedBox, NeverLosesAPointOfTheRay) {
    Random random(9);
    for (float scale : {1e-6f, 1.0f, 1.5e5f}) {
        const float extent = 4.0f * scale;
        for (int i = 0; i < 50000; ++i) {
            Vec3 origin = scale * random.point(-4, 4), d = random.direction();
            if (i % 3 == 0) d[i % 2] = i % 5 == 0 ? -0.0f : 0.0f;
            if (i % 7 == 0) origin[1] = scale * std::floor(random.uniform(-4, 4));
            const float t = scale * random.uniform(0.0f, 3.0f);
            const Vec3 p = origin + t * d;  // rounded: up to an ulp off the ray
            Box box = Box::empty();
            box.extend(p);
            if (i % 2 == 0) box.extend(p + scale * random.point(-0.5f, 0.5f));
            float near = 0.0f;
            ASSERT_TRUE(PaddedBox::test(node_of(box), PaddedBox::setup({origin, d, kInfinity}, extent),
                                        kInfinity, near))
                << "ray " << i << " scale " << scale;
            EXPECT_LE(near, t);
        }
    }
}

template <class Test>
class BoxTest : public testing::Test {};
using AllBoxTests = Rebind<testing::Types, BoxTests>;
TYPED_TEST_SUITE(BoxTest, AllBoxTests);

TYPED_TEST(BoxTest, Culls) {
    const BvhNode node = node_of({{1, 1, 1}, {2, 2, 2}});
    float near;
    const auto hits = [&](Vec3 o, Vec3 d, float tmax) {
        return TypeParam::test(node, TypeParam::setup({o, d, tmax}, 2.0f), tmax, near);
    };
    EXPECT_TRUE(hits({0, 0, 0}, {1, 1, 1}, kInfinity));
    EXPECT_FALSE(hits({0, 0, 0}, {-1, -1, -1}, kInfinity));
    EXPECT_FALSE(hits({0, 0, 0}, {1, 1, 1}, 0.99f));
    EXPECT_FALSE(hits({0, 0, 0}, {1, 0, 0}, kInfinity)) << "parallel to the slab and outside it";
    EXPECT_TRUE(hits({0, 1.5f, 1.5f}, {1, 0, 0}, kInfinity));
}

// A ray in a box's plane has a distance of 0 times infinity to it. Ize's order of minima drops that; in a
// plain test it may decide.
TEST(IzeBox, CountsARayInThePlaneOfAFaceAsInside) {
    const BvhNode node = node_of({{1, 1, 1}, {2, 2, 2}});
    const auto count = [&](auto tag) {
        using Test = typename decltype(tag)::type;
        int entered = 0;
        for (int axis = 0; axis < 3; ++axis)
            for (const float at : {1.0f, 2.0f})
                for (const float zero : {0.0f, -0.0f})
                    for (const float side : {1.0f, -1.0f}) {
                        Vec3 o = {1.5f, 1.5f, 1.5f}, d = {0, 0, 0};
                        const int along = (axis + 1) % 3;
                        o[axis] = at, o[along] = 1.5f - 2.0f * side;
                        d = {zero, zero, zero};
                        d[along] = side;
                        float near;
                        entered += Test::test(node, Test::setup({o, d, kInfinity}, 2.0f), kInfinity, near);
                    }
        return entered;
    };
    EXPECT_EQ(count(TypeTag<IzeBox>{}), 24);
    EXPECT_EQ(count(TypeTag<PaddedBox>{}), 24);
    EXPECT_LT(count(TypeTag<PlainBox>{}), 24);
}

}  // namespace
}  // namespace ctpbench
