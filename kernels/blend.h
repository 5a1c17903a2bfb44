// The blend stage: one more sample per pixel into the image, as a running mean. A plain sum in float loses
// its digits after some millions of samples; the mean does not.
#pragma once

#include "wavefront.h"

namespace ctpbench {

struct BlendKernel {
    PixelColumns pixels;
    ImageColumns image;
    std::uint32_t sample;  // how many samples the image holds already
    std::uint8_t*
        clamped;  // by pixel: whether the sample was no number, infinite or negative, and counts as 0

    CTP_INLINE void operator()(std::uint32_t i) const {
        Vec3 light = pixels.radiance(i);
        constexpr float largest = std::numeric_limits<float>::max();
        const bool sound = light.x >= 0.0f && light.x <= largest && light.y >= 0.0f && light.y <= largest &&
                           light.z >= 0.0f && light.z <= largest;
        if (!sound) light = {0.0f, 0.0f, 0.0f};
        clamped[i] = sound ? 0 : 1;
        const float share = 1.0f / static_cast<float>(sample + 1);
        blend(image.r[i], light.x, share);
        blend(image.g[i], light.y, share);
        blend(image.b[i], light.z, share);
    }

private:
    // The first sample replaces what was there, whatever it was.
    CTP_INLINE void blend(float& mean, float value, float share) const {
        mean = sample == 0 ? value : mean + (value - mean) * share;
    }
};

}  // namespace ctpbench
