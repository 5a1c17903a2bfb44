// The image that others are compared with, as two independent halves. The error of an image and the noise of
// its reference add up, and with a reference of finite length the second would pass for a plateau of the
// first; the product of the differences from two halves has no such term on average.
#pragma once

#include <cstddef>
#include <vector>

#include "wavefront/columns.h"

namespace ctpbench {

// What keeps dark pixels from counting too much in relMSE, a measure after Rousselle, Knaus and Zwicker
// ("Adaptive Sampling and Reconstruction using Greedy Error Minimization", SIGGRAPH Asia 2011). In radiance
// squared; the value is a convention.
inline constexpr double kDarkness = 1e-2;

class ReferenceImage {
public:
    // Two images of the same pixels, of as many samples each, from independent random numbers.
    ReferenceImage(const ImageStorage& a, const ImageStorage& b);

    std::size_t pixels() const { return a_.size() / 3; }

    // An unbiased estimate of mean((I - R)^2 / (R^2 + kDarkness)) over pixels and channels, R being what the
    // halves converge to: mean((I - A)(I - B) / (((A + B) / 2)^2 + kDarkness)). Below zero where an image is
    // no further from the truth than chance. The image must be independent of both halves.
    double relmse(const ImageStorage& image) const;

    // The same error of the halves' mean itself: what relmse() is free of.
    double noise() const;

    // Three values a pixel, red, green, blue: the halves and the weight 1 / (R^2 + kDarkness).
    const std::vector<double>& a() const { return a_; }
    const std::vector<double>& b() const { return b_; }
    const std::vector<double>& weight() const { return weight_; }

private:
    std::vector<double> a_, b_, weight_;
};

}  // namespace ctpbench
