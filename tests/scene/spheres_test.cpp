#include "scene/spheres.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/scene/files.h"

namespace ctpbench {
namespace {

const Box kBox{{-1, 2, 10}, {3, 4, 11}};

TEST(Spheres, HaveTheRadiusOfTheFormula) {
    const auto spheres = scatter_spheres(kBox, 1000, 0.03f, 1);
    ASSERT_EQ(spheres.size(), 1000u);
    const float expected = static_cast<float>(0.03f * std::cbrt(4.0 * 2.0 * 1.0 / 1000.0));
    for (const SphereShape& sphere : spheres) EXPECT_EQ(sphere.radius, expected);
    EXPECT_DOUBLE_EQ(mean_spacing(kBox, 8), 1.0);
}

// Chi-square with 9 degrees of freedom per axis: above 33.7 with probability 1e-4.
TEST(Spheres, AreUniformInTheBox) {
    const auto spheres = scatter_spheres(kBox, 10000, 0.03f, 7);
    for (int axis = 0; axis < 3; ++axis) {
        double bins[10] = {};
        for (const SphereShape& sphere : spheres) {
            const float at = sphere.center[axis];
            ASSERT_GE(at, kBox.lo[axis]);
            ASSERT_LE(at, kBox.hi[axis]);
            ++bins[std::min(9, static_cast<int>(10.0f * (at - kBox.lo[axis]) / kBox.extent()[axis]))];
        }
        double chi_square = 0.0;
        for (const double count : bins) chi_square += (count - 1000.0) * (count - 1000.0) / 1000.0;
        EXPECT_LT(chi_square, 33.7) << "axis " << axis;
    }
}

TEST(Spheres, DependOnTheSeedAndTheIndexAlone) {
    const auto few = scatter_spheres(kBox, 10, 0.03f, 5), many = scatter_spheres(kBox, 1000, 0.03f, 5);
    const auto other = scatter_spheres(kBox, 10, 0.03f, 6),
               high = scatter_spheres(kBox, 10, 0.03f, 5 + (1ull << 32));
    for (std::size_t i = 0; i < few.size(); ++i) {
        EXPECT_EQ(few[i].center, many[i].center);
        EXPECT_FALSE(few[i].center == other[i].center);
        EXPECT_FALSE(few[i].center == high[i].center);
    }
}

// The first block of Philox4x32-10 for key 0 and counter 0 is published with the generator (Salmon et al.
// 2011): 6627e8d5 e169c58d bc57ac4c 9b00dbd8.
TEST(Spheres, AreThePublishedPhiloxNumbers) {
    const auto spheres = scatter_spheres({{0, 0, 0}, {1, 1, 1}}, 1, 0.03f, 0);
    const auto unit = [](std::uint32_t word) { return static_cast<float>((word + 0.5) * 0x1p-32); };
    EXPECT_EQ(spheres[0].center, (Vec3{unit(0x6627e8d5), unit(0xe169c58d), unit(0xbc57ac4c)}));
}

TEST(Spheres, FillFlatBoxes) {
    const Box flat{{0, 5, 0}, {4, 5, 9}}, line{{2, 5, 0}, {2, 5, 10}};
    EXPECT_DOUBLE_EQ(mean_spacing(flat, 4), 3.0);
    EXPECT_DOUBLE_EQ(mean_spacing(line, 5), 2.0);
    for (const SphereShape& sphere : scatter_spheres(flat, 4, 0.5f, 1)) {
        EXPECT_EQ(sphere.center.y, 5.0f);
        EXPECT_EQ(sphere.radius, 1.5f);
    }
}

TEST(Spheres, FillHugeBoxes) {
    const Box huge{{-1e18f, -1e18f, -1e18f}, {1e18f, 1e18f, 1e18f}};
    for (const SphereShape& sphere : scatter_spheres(huge, 10, 0.5f, 1))
        EXPECT_TRUE(std::isfinite(sphere.radius));
}

TEST(Spheres, RefuseWhatHasNoExtentOrRadius) {
    EXPECT_TRUE(scatter_spheres(Box::empty(), 0, 0.03f, 1).empty());
    EXPECT_ERROR(scatter_spheres(Box::empty(), 1, 0.03f, 1), ExitCode::usage, "without extent");
    EXPECT_ERROR(scatter_spheres({{1, 1, 1}, {1, 1, 1}}, 1, 0.03f, 1), ExitCode::usage, "without extent");
    EXPECT_ERROR(scatter_spheres(kBox, 1, 0.0f, 1), ExitCode::usage, "is not positive");
    EXPECT_ERROR(scatter_spheres(kBox, 1, -1.0f, 1), ExitCode::usage, "is not positive");
    EXPECT_ERROR(scatter_spheres(kBox, 1, NAN, 1), ExitCode::usage, "is not positive");
    EXPECT_ERROR(scatter_spheres(kBox, 1, INFINITY, 1), ExitCode::usage, "is not positive");
}

}  // namespace
}  // namespace ctpbench
