// Between two facing mirrors a path's light is known exactly: its reflectance to the power of the number of
// reflections, which unfolding the mirrors tells without tracing anything.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "wavefront/physics.h"

namespace ctpbench {
namespace {

using test::gray;

constexpr float kHalfWidth = 12.0f;  // of the mirrors, which are at heights -1 and 1
const Vec3 kEye{0.3f, 0.4f, 0.25f};

// How often a ray from the eye is reflected before it leaves through the open sides; negative if it leaves so
// close to a mirror's edge that rounding decides.
int reflections(Vec3 d) {
    const auto to_side = [](double o, double along) {
        return along == 0.0 ? std::numeric_limits<double>::infinity()
                            : ((along > 0.0 ? kHalfWidth : -kHalfWidth) - o) / along;
    };
    const double t = std::fmin(to_side(kEye.x, d.x), to_side(kEye.y, d.y));
    // Mirrored copies of the gap lie one above the other, each 2 high: count the walls between.
    const double rise = d.z < 0.0 ? -d.z : d.z, from = d.z < 0.0 ? -kEye.z : kEye.z;
    const double walls = (from + t * rise + 1.0) / 2.0;
    const double nearest = std::fabs(walls - std::round(walls));
    return nearest < 1e-3 ? -1 : static_cast<int>(std::floor(walls));
}

TEST(FacingMirrors, MultiplyTheirReflectance) {
    const Vec3 reflectance{0.9f, 0.5f, 1.0f};
    Scene scene;
    test::add_material(scene, test::mirror(reflectance));
    test::add_square(scene, kHalfWidth, 1.0f, 0);
    test::add_square(scene, kHalfWidth, -1.0f, 0);
    for (const std::uint32_t bounces : {12u, 3u, 0u}) {
        test::Stage stage(scene, 2);
        Camera camera = test::looking_from(kEye, kEye + Vec3{1, 0.2f, 0.3f});
        camera.up = {0, 0, 1}, camera.fov_degrees = 100.0f;
        std::vector<Vec3> directions(96 * 96);
        const test::Frames frames =
            test::render(stage, camera, {96, 96, bounces, 2}, 1, "ctp", [&](const BounceView& view) {
                if (view.bounce != 0) return;
                for (const std::uint32_t slot : view.slots) directions[slot] = view.rays.load(slot).direction;
            });
        std::map<int, int> seen;
        for (std::size_t i = 0; i < directions.size(); ++i) {
            const int k = reflections(directions[i]);
            ++seen[k];
            if (k < 0) continue;
            Vec3 expected = gray(1.0f);
            for (int j = 0; j < k; ++j) expected = expected * reflectance;
            if (k > static_cast<int>(bounces)) expected = gray(0.0f);
            ASSERT_EQ(frames.image.at(i), expected) << k << " reflections, pixel " << i;
        }
        EXPECT_LT(seen[-1], 100) << "left out";
        for (int k = 0; k <= 13; ++k) EXPECT_GT(seen[k], 10) << k << " reflections";
    }
}

}  // namespace
}  // namespace ctpbench
