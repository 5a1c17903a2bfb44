#include "kernels/primitives/triangle_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace ctpbench::test {
namespace {

class Uniform {
public:
    float operator()(float lo, float hi) { return std::uniform_real_distribution<float>(lo, hi)(engine_); }
    Vec3 point(float lo, float hi) { return {(*this)(lo, hi), (*this)(lo, hi), (*this)(lo, hi)}; }

private:
    std::mt19937 engine_{1};
};

// Calls f with many points of the triangle in double.
template <class F>
void for_each_sample(const TriangleShape& t, int steps, const F& f) {
    for (int i = 0; i <= steps; ++i) {
        for (int j = 0; i + j <= steps; ++j) {
            const double u = double(i) / steps, v = double(j) / steps;
            std::array<double, 3> p;
            for (int a = 0; a < 3; ++a) {
                p[a] = t.a[a] + u * (double{t.b[a]} - t.a[a]) + v * (double{t.c[a]} - t.a[a]);
            }
            f(p);
        }
    }
}

bool inside(const Box& box, const std::array<double, 3>& p) {
    for (int a = 0; a < 3; ++a) {
        if (!(p[a] >= box.lo[a] && p[a] <= box.hi[a])) return false;
    }
    return true;
}

Box random_box(Uniform& uniform, Vec3 center) {
    const Vec3 p = center + uniform.point(-1, 1), q = center + uniform.point(-1, 1);
    return {min(p, q), max(p, q)};
}

TEST(TriangleBounds, AreTheCorners) {
    const Box box = bounds(TriangleShape{{1, 5, 3}, {-1, 0, 9}, {4, 2, -6}});
    EXPECT_EQ(box.lo, (Vec3{-1, 0, -6}));
    EXPECT_EQ(box.hi, (Vec3{4, 5, 9}));
}

TEST(TriangleBounds, NotFiniteIsEmpty) {
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        for (int corner = 0; corner < 3; ++corner) {
            TriangleShape t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
            (corner == 0 ? t.a : corner == 1 ? t.b : t.c).y = bad;
            EXPECT_TRUE(bounds(t).is_empty()) << corner;
        }
    }
}

TEST(TriangleBounds, ClipHoldsEverySampleInTheBoxAndIsTight) {
    Uniform uniform;
    double volume_of_clip = 0, volume_of_samples = 0;
    for (const float offset : {0.0f, 1e4f}) {
        for (int k = 0; k < 1000; ++k) {
            const Vec3 center{offset, -offset, offset};
            const TriangleShape t{center + uniform.point(-1, 1), center + uniform.point(-1, 1),
                                  center + uniform.point(-1, 1)};
            const Box box = random_box(uniform, center);
            const Box part = clip(t, box);
            std::array<double, 3> lo{1e30, 1e30, 1e30}, hi{-1e30, -1e30, -1e30};
            for_each_sample(t, 60, [&](const auto& p) {
                if (!inside(box, p)) return;
                EXPECT_TRUE(inside(part, p));
                for (int a = 0; a < 3; ++a) lo[a] = std::min(lo[a], p[a]), hi[a] = std::max(hi[a], p[a]);
            });
            if (part.is_empty()) continue;
            EXPECT_TRUE(box.contains(part));
            EXPECT_TRUE(bounds(t).contains(part));
            if (lo[0] > hi[0] || offset != 0) continue;
            volume_of_clip += part.half_area();
            volume_of_samples += (hi[0] - lo[0]) * (hi[1] - lo[1]) + (hi[1] - lo[1]) * (hi[2] - lo[2]) +
                                 (hi[2] - lo[2]) * (hi[0] - lo[0]);
        }
    }
    EXPECT_LT(volume_of_clip, 1.15 * volume_of_samples);
}

TEST(TriangleBounds, ClipToItsOwnBoundsChangesNothing) {
    Uniform uniform;
    for (int k = 0; k < 100; ++k) {
        const TriangleShape t{uniform.point(-1, 1), uniform.point(-1, 1), uniform.point(-1, 1)};
        const Box whole = bounds(t), part = clip(t, whole);
        EXPECT_EQ(part.lo, whole.lo);
        EXPECT_EQ(part.hi, whole.hi);
    }
}

TEST(TriangleBounds, ClipOfWhatIsOutsideIsEmpty) {
    const TriangleShape t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_TRUE(clip(t, {{2, 2, 2}, {3, 3, 3}}).is_empty());
    // Inside the bounds, but beyond the long edge.
    EXPECT_TRUE(clip(t, {{0.9f, 0.9f, -1}, {1, 1, 1}}).is_empty());
}

TEST(TriangleBounds, ATouchIsKept) {
    const TriangleShape t{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const Box corner = clip(t, {{1, -1, -1}, {2, 1, 1}});
    EXPECT_EQ(corner.lo.x, 1.0f);
    EXPECT_EQ(corner.hi.x, 1.0f);
    EXPECT_TRUE(corner.lo.y <= 0 && corner.hi.y >= 0);
    EXPECT_FALSE(clip(t, {{-1, -1, 0}, {2, 2, 1}}).is_empty());
}

// Clipped again and again, as a reference is on its way down a tree: nothing between the parts is lost.
TEST(TriangleBounds, RepeatedCutsLoseNoPoint) {
    Uniform uniform;
    for (int k = 0; k < 200; ++k) {
        const Vec3 center{1e4f, 1e4f, -1e4f};
        const TriangleShape t{center + uniform.point(-1, 1), center + uniform.point(-1, 1),
                              center + uniform.point(-1, 1)};
        std::vector<Box> parts{bounds(t)};
        for (int cut = 0; cut < 6; ++cut) {
            std::vector<Box> next;
            const int axis = cut % 3;
            for (const Box& b : parts) {
                Box left = b, right = b;
                left.hi[axis] = right.lo[axis] =
                    max(b.lo[axis], min(b.hi[axis], uniform(b.lo[axis], b.hi[axis])));
                for (const Box& half : {left, right}) {
                    const Box part = clip(t, half);
                    if (!part.is_empty()) next.push_back(part);
                }
            }
            parts = next;
        }
        for_each_sample(t, 40, [&](const auto& p) {
            bool found = false;
            for (const Box& b : parts) {
                Box wide = b;  // by what a double sample may be off: nothing in float
                found = found || (p[0] >= wide.lo.x - 1e-11 && p[0] <= wide.hi.x + 1e-11 &&
                                  p[1] >= wide.lo.y - 1e-11 && p[1] <= wide.hi.y + 1e-11 &&
                                  p[2] >= wide.lo.z - 1e-11 && p[2] <= wide.hi.z + 1e-11);
            }
            EXPECT_TRUE(found);
        });
    }
}

template <int axis>
void expect_slices_as_clipped(const TriangleShape& t) {
    const Box whole = bounds(t);
    std::array<float, 6> planes;
    for (int i = 0; i < 6; ++i) {
        planes[i] = whole.lo[axis] + (whole.hi[axis] - whole.lo[axis]) * 0.2f * static_cast<float>(i);
    }
    planes[5] = whole.hi[axis];
    const auto cut = slicer<axis>(t);
    for (int i = 0; i < 5; ++i) {
        Box slab = whole;
        slab.lo[axis] = planes[i];
        slab.hi[axis] = planes[i + 1];
        const Box part = clip(t, slab);
        float lo[2], hi[2];
        cut(planes[i], planes[i + 1], lo, hi);
        for (int k = 0; k < 2; ++k) {
            const int other = (axis + 1 + k) % 3;
            EXPECT_NEAR(lo[k], part.lo[other], 1e-4f) << i;
            EXPECT_NEAR(hi[k], part.hi[other], 1e-4f) << i;
        }
    }
}

TEST(TriangleBounds, SlicerAgreesWithClip) {
    Uniform uniform;
    for (int k = 0; k < 500; ++k) {
        TriangleShape t{uniform.point(-1, 1), uniform.point(-1, 1), uniform.point(-1, 1)};
        for (int axis = 0; axis < 3; ++axis) {
            // An edge across the axis, or all of it.
            if (k % 7 == 0) t.b[axis] = t.a[axis];
            if (k % 7 == 1) t.b[axis] = t.c[axis];
            if (k % 49 == 0) t.c[axis] = t.a[axis];
        }
        SCOPED_TRACE(k);
        expect_slices_as_clipped<0>(t);
        expect_slices_as_clipped<1>(t);
        expect_slices_as_clipped<2>(t);
    }
}

}  // namespace
}  // namespace ctpbench::test
