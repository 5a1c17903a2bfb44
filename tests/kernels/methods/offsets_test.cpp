// Where the next ray of a path starts. What offsets do in whole frames is in
// tests/wavefront/offsets_test.cpp.
#include <gtest/gtest.h>

#include "kernels/methods/lists.h"
#include "support.h"

namespace ctpbench {
namespace {

using test::kInfinity;
using test::Random;

TEST(WaechterBinder, LeavesAConvexBallForGood) {
    Random random(4);
    for (float scale : {1.0f, 1e3f}) {
        for (float shift : {0.0f, 1e4f}) {
            const Vec3 center = {shift, -shift, shift};
            int returned = 0;
            for (int i = 0; i < 20000; ++i) {
                const Vec3 n = random.direction();
                const Vec3 p = center + scale * n;
                Vec3 d = random.direction();
                if (dot(d, n) < 0.0f) d = -d;
                const Ray ray = {WaechterBinder::origin(p, n, d, 1.0f), d, kInfinity};
                Hit hit = no_hit(ray);
                StableSphere::intersect(StableSphere::shape({center, scale}), 0, StableSphere::setup(ray),
                                        hit);
                returned += hit.primitive == 0;
            }
            EXPECT_EQ(returned, 0) << "scale " << scale << ", shift " << shift;
        }
    }
}

TEST(Offsets, MoveAlongTheRayByWhatTheyName) {
    const Vec3 p = {1, 2, 3}, n = {0, 0, 1}, d = {0, 1, 0};
    EXPECT_EQ(ConstantEpsilon::origin(p, n, d, 50.0f), (Vec3{1, 2.0f + 1e-4f, 3}));
    EXPECT_EQ(RelativeEpsilon::origin(p, n, d, 50.0f), (Vec3{1, 2.0f + 1e-3f * 50.0f, 3}));
    EXPECT_EQ(ExcludeId::origin(p, n, d, 50.0f), p);
    EXPECT_GT(WaechterBinder::origin(p, n, d, 50.0f).z, p.z);
}

}  // namespace
}  // namespace ctpbench
