#include "kernels/texture.h"

#include <gtest/gtest.h>

#include <vector>

#include "support.h"

namespace ctpbench {
namespace {

constexpr float kUnit = 1.0f / 65535.0f;
constexpr float kRounding = 1e-6f;

// A texture of random texels that does not begin where the arena does.
struct Image {
    Image(std::uint16_t width, std::uint16_t height) : texture{13, width, height} {
        test::Random random(width * 100u + height);
        const auto channel = [&] { return static_cast<std::uint16_t>(random.uniform(0.0f, 65535.0f)); };
        for (std::uint32_t i = 0; i < texture.first + width * height; ++i)
            arena.push_back({channel(), channel(), channel(), channel()});
    }
    const Texel& at(std::uint32_t x, std::uint32_t y) const {
        return arena[texture.first + y * texture.width + x];
    }
    TextureSample sample(float u, float v) const { return sample_texture(arena.data(), texture, {u, v}); }

    Texture texture;
    std::vector<Texel> arena;
};

// The mean of those texels, each as often as it is named.
void expect_mean(const TextureSample& s, const std::vector<Texel>& of) {
    double r = 0.0, g = 0.0, b = 0.0, a = 0.0;
    for (const Texel& t : of) r += t.r, g += t.g, b += t.b, a += t.a;
    const double scale = double{kUnit} / static_cast<double>(of.size());
    EXPECT_NEAR(s.color.x, r * scale, kRounding);
    EXPECT_NEAR(s.color.y, g * scale, kRounding);
    EXPECT_NEAR(s.color.z, b * scale, kRounding);
    EXPECT_NEAR(s.alpha, a * scale, kRounding);
}

// Sizes that are powers of two, where centres are exact, so that nothing of a neighbour creeps in.
TEST(Texture, IsItsTexelsAtTheirCentres) {
    for (const auto& [w, h] : {std::pair<int, int>{4, 8}, {1, 1}, {1, 4}, {16, 1}}) {
        const Image image(w, h);
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) {
                SCOPED_TRACE(testing::Message() << x << ", " << y << " of " << w << " x " << h);
                const float u = (x + 0.5f) / w, v = (y + 0.5f) / h;
                expect_mean(image.sample(u, v), {image.at(x, y)});
                // It repeats, to either side.
                expect_mean(image.sample(u - 3.0f, v + 5.0f), {image.at(x, y)});
                expect_mean(image.sample(u + 1.0f, v - 1.0f), {image.at(x, y)});
            }
    }
}

TEST(Texture, IsTheMeanOfNeighboursHalfway) {
    for (const auto& [w, h] : {std::pair<int, int>{4, 8}, {1, 1}, {2, 1}, {1, 4}}) {
        const Image image(w, h);
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) {
                SCOPED_TRACE(testing::Message() << x << ", " << y << " of " << w << " x " << h);
                const int left = (x + w - 1) % w, below = (y + h - 1) % h;  // over the edge, too
                const float u = static_cast<float>(x) / w, v = static_cast<float>(y) / h;
                const float middle_u = (x + 0.5f) / w, middle_v = (y + 0.5f) / h;
                expect_mean(image.sample(u, middle_v), {image.at(left, y), image.at(x, y)});
                expect_mean(image.sample(middle_u, v), {image.at(x, below), image.at(x, y)});
                expect_mean(image.sample(u, v),
                            {image.at(left, below), image.at(x, below), image.at(left, y), image.at(x, y)});
            }
    }
}

TEST(Texture, IsLinearInBetween) {
    const Image image(4, 4);
    // A quarter of the way from texel 1 to 2, three quarters of the way from row 2 to 3.
    std::vector<Texel> of;
    for (const auto& [x, y, times] : {std::array<int, 3>{1, 2, 3}, {2, 2, 1}, {1, 3, 9}, {2, 3, 3}})
        of.insert(of.end(), times, image.at(x, y));
    expect_mean(image.sample(1.75f / 4, 3.25f / 4), of);
}

// v = 0 is below the bottom row, which comes first in the arena.
TEST(Texture, HasItsFirstRowAtTheBottom) {
    const std::vector<Texel> arena = {{10000, 0, 0, 0}, {20000, 0, 0, 0}, {30000, 0, 0, 0}, {40000, 0, 0, 0}};
    const Texture tower{0, 1, 4};
    EXPECT_NEAR(sample_texture(arena.data(), tower, {0.5f, 0.125f}).color.x, 10000 * kUnit, kRounding);
    EXPECT_NEAR(sample_texture(arena.data(), tower, {0.5f, 0.875f}).color.x, 40000 * kUnit, kRounding);
    const Texture row{0, 4, 1};
    EXPECT_NEAR(sample_texture(arena.data(), row, {0.125f, 0.5f}).color.x, 10000 * kUnit, kRounding);
    EXPECT_NEAR(sample_texture(arena.data(), row, {0.875f, 0.5f}).color.x, 40000 * kUnit, kRounding);
}

// Wherever it is asked it reads its own texels only: the arena around it is full of what would show.
TEST(Texture, StaysWithinItself) {
    test::Random random(9);
    for (const auto& [w, h] : {std::pair<int, int>{3, 5}, {1, 1}, {1, 7}, {300, 2}}) {
        std::vector<Texel> arena(3u * w * h, {65535, 65535, 65535, 65535});
        const Texture texture{static_cast<std::uint32_t>(w * h), static_cast<std::uint16_t>(w),
                              static_cast<std::uint16_t>(h)};
        std::fill(arena.begin() + w * h, arena.begin() + 2 * w * h, Texel{0, 0, 0, 0});
        const auto expect_black = [&](float u, float v) {
            const TextureSample s = sample_texture(arena.data(), texture, {u, v});
            ASSERT_EQ(s.color, (Vec3{0, 0, 0})) << u << ", " << v;
            ASSERT_EQ(s.alpha, 0.0f);
        };
        // Among them: just below 0, where t - floor(t) rounds to 1; and so large that no fraction is left.
        const float special[] = {0.0f,       -0.0f, 1.0f,  -1.0f, -1e-10f, 1.0f - 0x1p-24f,
                                 -0x1p-126f, 1e30f, -1e30f};
        for (const float u : special)
            for (const float v : special) expect_black(u, v);
        for (int i = 0; i < 10000; ++i)
            expect_black(random.uniform(-9.0f, 9.0f), random.uniform(-9.0f, 9.0f));
    }
}

TEST(Texture, OfOneIsOneEverywhere) {
    const std::vector<Texel> arena(7 * 5, {65535, 65535, 65535, 65535});
    test::Random random(8);
    for (int i = 0; i < 10000; ++i) {
        const Vec2 uv{random.uniform(-2.0f, 2.0f), random.uniform(-2.0f, 2.0f)};
        const TextureSample s = sample_texture(arena.data(), {0, 7, 5}, uv);
        ASSERT_NEAR(s.color.x, 1.0f, kRounding);
        ASSERT_NEAR(s.alpha, 1.0f, kRounding);
    }
}

TEST(Texture, ExistsIfItHasASize) {
    EXPECT_FALSE(Texture{}.exists());
    EXPECT_TRUE((Texture{0, 1, 1}.exists()));
}

}  // namespace
}  // namespace ctpbench
