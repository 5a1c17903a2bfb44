#include "kernels/primitives/sphere_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace ctpbench::test {
namespace {

template <class F>
void for_each_sample(const SphereShape& s, int steps, const F& f) {
    for (int i = 0; i <= steps; ++i) {
        for (int j = 0; j < 2 * steps; ++j) {
            const double theta = M_PI * i / steps, phi = M_PI * j / steps;
            f(std::array<double, 3>{s.center.x + s.radius * std::sin(theta) * std::cos(phi),
                                    s.center.y + s.radius * std::sin(theta) * std::sin(phi),
                                    s.center.z + s.radius * std::cos(theta)});
        }
    }
}

bool inside(const Box& box, const std::array<double, 3>& p) {
    for (int a = 0; a < 3; ++a) {
        if (!(p[a] >= box.lo[a] && p[a] <= box.hi[a])) return false;
    }
    return true;
}

TEST(SphereBounds, HoldTheSphereAndAreTight) {
    for (const SphereShape& s : {SphereShape{{0, 0, 0}, 1}, SphereShape{{1e4f, -7, 0.1f}, 0.01f},
                                 SphereShape{{3, 3, 3}, 1e6f}, SphereShape{{1, 2, 3}, 0}}) {
        const Box box = bounds(s);
        for_each_sample(s, 24, [&](const auto& p) { EXPECT_TRUE(inside(box, p)); });
        for (int a = 0; a < 3; ++a) {
            const float ulps = 4 * 0x1p-23f * (std::fabs(s.center[a]) + s.radius) + 1e-36f;
            EXPECT_LE(box.hi[a] - box.lo[a], 2 * s.radius + ulps);
        }
    }
}

TEST(SphereBounds, NoRadiusNoBounds) {
    EXPECT_TRUE(bounds(SphereShape{{0, 0, 0}, -1}).is_empty());
    EXPECT_TRUE(bounds(SphereShape{{0, 0, 0}, std::numeric_limits<float>::quiet_NaN()}).is_empty());
}

TEST(SphereBounds, ClipHoldsEverySampleInTheBox) {
    std::mt19937 engine(1);
    const auto uniform = [&](float lo, float hi) {
        return std::uniform_real_distribution<float>(lo, hi)(engine);
    };
    const auto point = [&] { return Vec3{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; };
    for (const float offset : {0.0f, 1e4f}) {
        const Vec3 center{offset, offset, -offset};
        for (int k = 0; k < 500; ++k) {
            const SphereShape s{center + point(), uniform(0.1f, 1)};
            const Vec3 p = center + 2 * point(), q = center + 2 * point();
            const Box box{min(p, q), max(p, q)}, part = clip(s, box);
            for_each_sample(s, 24, [&](const auto& sample) {
                if (inside(box, sample)) {
                    EXPECT_TRUE(inside(part, sample));
                }
            });
            if (part.is_empty()) continue;
            EXPECT_TRUE(box.contains(part));
            EXPECT_TRUE(bounds(s).contains(part));
        }
    }
}

TEST(SphereBounds, ClipByHand) {
    const SphereShape s{{0, 0, 0}, 5};
    const Box cap = clip(s, {{3, -9, -9}, {9, 9, 9}});
    EXPECT_EQ(cap.lo.x, 3.0f);
    EXPECT_NEAR(cap.hi.x, 5, 1e-5);
    EXPECT_NEAR(cap.lo.y, -4, 1e-5);
    EXPECT_NEAR(cap.hi.z, 4, 1e-5);
    EXPECT_TRUE(clip(s, {{4, 4, -9}, {9, 9, 9}}).is_empty()) << "beside the ball, inside its bounds";
    EXPECT_FALSE(clip(s, {{5, -1, -1}, {9, 1, 1}}).is_empty()) << "a touch is kept";
}

template <int axis>
void expect_slices_as_clipped(const SphereShape& s) {
    const auto cut = slicer<axis>(s);
    for (int i = 0; i < 8; ++i) {
        Box slab = bounds(s);
        slab.lo[axis] = s.center[axis] - 2 + 0.5f * static_cast<float>(i);
        slab.hi[axis] = slab.lo[axis] + 0.5f;
        const Box part = clip(s, slab);
        float lo[2], hi[2];
        cut(slab.lo[axis], slab.hi[axis], lo, hi);
        for (int k = 0; k < 2; ++k) {
            const int other = (axis + 1 + k) % 3;
            EXPECT_NEAR(lo[k], part.lo[other], 1e-3f) << i;
            EXPECT_NEAR(hi[k], part.hi[other], 1e-3f) << i;
        }
    }
}

TEST(SphereBounds, SlicerAgreesWithClip) {
    const SphereShape s{{1, 2, 3}, 2};
    expect_slices_as_clipped<0>(s);
    expect_slices_as_clipped<1>(s);
    expect_slices_as_clipped<2>(s);
}

}  // namespace
}  // namespace ctpbench::test
