// The squared bias of a renderer: the relMSE that stays however many samples are taken. Images of independent
// seeds share their bias and not their noise, so that products of two images' errors tell it without waiting
// for the curve to flatten.
#pragma once

#include <cstddef>
#include <vector>

#include "measure/bounded_value.h"
#include "measure/reference_image.h"

namespace ctpbench {

class ImageBias {
public:
    // An image of a further seed, of as many samples as the others. Images are summed up, not kept.
    void add(const ImageStorage& image);

    std::size_t images() const { return images_; }

    // The mean over pixels and channels of (I - A)(J - B) / (R^2 + kDarkness) over all pairs I, J of
    // different images: unbiased, since I, J and the halves A, B are independent. May be below zero where
    // there is no bias. Pixels draw random numbers of their own, so the interval is that of a mean over
    // independent pixels; it also holds what the reference contributes. NaN with fewer than two images.
    BoundedValue relmse(const ReferenceImage& reference) const;

private:
    std::size_t images_ = 0;
    std::vector<double> sum_, squares_;  // three values a pixel
};

}  // namespace ctpbench
