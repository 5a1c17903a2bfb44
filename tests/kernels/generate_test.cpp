#include "kernels/generate.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "kernels/surface.h"
#include "wavefront/columns.h"

namespace ctpbench {
namespace {

TEST(Random4, IsAFunctionOfItsCounterAlone) {
    const Random4 a = random4(1, 2, 3, 4, Dimension::direction);
    const Random4 b = random4(1, 2, 3, 4, Dimension::direction);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(a.v[i], b.v[i]);
    EXPECT_NE(a.v[0], random4(2, 2, 3, 4, Dimension::direction).v[0]);
    EXPECT_NE(a.v[0], random4(1ull << 32 | 1, 2, 3, 4, Dimension::direction).v[0]);
    EXPECT_NE(a.v[0], random4(1, 3, 3, 4, Dimension::direction).v[0]);
    EXPECT_NE(a.v[0], random4(1, 2, 3, 5, Dimension::direction).v[0]);
    EXPECT_NE(a.v[0], random4(1, 2, 3, 4, Dimension::camera).v[0]);
}

// Sixty-four equal bins; the chi-square statistic of 63 degrees of freedom exceeds 103.4 once in a thousand.
TEST(Random4, IsUniform) {
    std::array<int, 64> bins{};
    constexpr int n = 100000;
    for (std::uint32_t i = 0; i < n / 4; ++i)
        for (float v : random4(1, i, 0, 0, Dimension::direction).v) {
            ASSERT_GE(v, 0.0f);
            ASSERT_LT(v, 1.0f);
            ++bins[static_cast<std::size_t>(v * 64.0f)];
        }
    double chi_square = 0.0;
    for (int count : bins) chi_square += (count - n / 64.0) * (count - n / 64.0) / (n / 64.0);
    EXPECT_LT(chi_square, 103.4);
}

// Lambert's law: cos^2 of the angle to the normal is uniform, and so is the angle about it.
TEST(CosineDirection, FollowsLambertsLaw) {
    for (const Vec3 n : {Vec3{0, 0, 1}, Vec3{0, 0, -1}, normalize({1, -2, 0.5f})}) {
        std::array<int, 32> bins{};
        Vec3 mean = {0, 0, 0};
        constexpr int samples = 64000;
        for (std::uint32_t i = 0; i < samples; ++i) {
            const Random4 r = random4(3, i, 0, 0, Dimension::direction);
            const Vec3 d = cosine_direction(n, r.v[0], r.v[1]);
            const float cosine = dot(d, n);
            ASSERT_GE(cosine, -1e-6f);
            ASSERT_NEAR(length(d), 1.0f, 1e-5f);
            ++bins[std::min<std::size_t>(31,
                                         static_cast<std::size_t>(std::max(0.0f, cosine * cosine) * 32.0f))];
            mean = mean + d * (1.0f / samples);
        }
        double chi_square = 0.0;
        for (int count : bins)
            chi_square += (count - samples / 32.0) * (count - samples / 32.0) / (samples / 32.0);
        EXPECT_LT(chi_square, 61.1);  // 31 degrees of freedom, one in a thousand
        EXPECT_NEAR(length(mean - n * (2.0f / 3.0f)), 0.0f, 0.01f);
    }
}

TEST(GenerateKernel, FillsTheImageFromTheEye) {
    constexpr std::uint32_t width = 40, height = 20;
    RayStorage rays;
    PixelStorage pixels;
    rays.resize(width * height), pixels.resize(width * height);
    std::vector<std::uint32_t> index(width * height);
    const CameraFrame frame = camera_frame({1, 2, 3}, {1, 2, 2}, {0, 1, 0}, 90.0f, width, height);
    const GenerateKernel kernel{frame, width, height, 1, 0, rays.view(), pixels.view(), index.data()};
    for (std::uint32_t i = 0; i < width * height; ++i) kernel(i);
    for (std::uint32_t i = 0; i < width * height; ++i) {
        const Ray ray = rays.view().load(i);
        EXPECT_EQ(ray.origin, (Vec3{1, 2, 3}));
        EXPECT_EQ(index[i], i);
        // The 90 degrees span the 20 rows; the field is twice as wide.
        const float x = ray.direction.x / -ray.direction.z, y = ray.direction.y / -ray.direction.z;
        EXPECT_GE(x, 2.0f * (2.0f * (static_cast<float>(i % width)) / width - 1.0f) - 1e-4f);
        EXPECT_LE(x, 2.0f * (2.0f * (static_cast<float>(i % width) + 1.0f) / width - 1.0f) + 1e-4f);
        EXPECT_LE(y, 1.0f - 2.0f * static_cast<float>(i / width) / height + 1e-4f);
        EXPECT_GE(y, 1.0f - 2.0f * (static_cast<float>(i / width) + 1.0f) / height - 1e-4f);
    }
}

}  // namespace
}  // namespace ctpbench
