// Images whose truth, noise and bias are known, in the place of rendered ones.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "wavefront/columns.h"

namespace ctpbench::test {

inline constexpr std::size_t kNoisyPixels = 900;

// The truth of a pixel: dark to bright, and some quite black.
inline float true_radiance(std::size_t pixel) { return 0.002f * static_cast<float>(pixel % 500); }

// A progressive image: each sample is the truth, plus `bias`, plus noise of this deviation.
class NoisyImage {
public:
    explicit NoisyImage(std::uint64_t seed, double deviation = 0.5, double bias = 0.0)
        : random_(seed), deviation_(deviation), bias_(bias) {
        image_.resize(kNoisyPixels);
        for (float* channel : {image_.view().r, image_.view().g, image_.view().b})
            std::fill(channel, channel + kNoisyPixels, 0.0f);
    }
    void add_samples(int count) {
        for (int i = 0; i < count; ++i) add_sample();
    }
    const ImageStorage& image() const { return image_; }

private:
    void add_sample() {
        ++samples_;
        const ImageColumns view = image_.view();
        for (std::size_t p = 0; p < kNoisyPixels; ++p)
            for (float* channel : {view.r, view.g, view.b}) {
                const double sample = true_radiance(p) + bias_ + deviation_ * noise_(random_);
                channel[p] += (static_cast<float>(sample) - channel[p]) / static_cast<float>(samples_);
            }
    }

    std::mt19937_64 random_;
    std::normal_distribution<double> noise_;
    double deviation_, bias_;
    int samples_ = 0;
    ImageStorage image_;
};

inline ImageStorage noisy_image(std::uint64_t seed, int samples, double deviation = 0.5, double bias = 0.0) {
    NoisyImage noisy(seed, deviation, bias);
    noisy.add_samples(samples);
    return noisy.image();
}

// mean(squared_error / (R^2 + 0.01)) when every pixel and channel has this squared error.
inline double relmse_of(double squared_error) {
    double sum = 0.0;
    for (std::size_t p = 0; p < kNoisyPixels; ++p) {
        const double truth = true_radiance(p);
        sum += squared_error / (truth * truth + 1e-2);
    }
    return sum / static_cast<double>(kNoisyPixels);
}

}  // namespace ctpbench::test
