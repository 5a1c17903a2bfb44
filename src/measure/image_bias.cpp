#include "measure/image_bias.h"

namespace ctpbench {

void ImageBias::add(const ImageStorage& image) {
    sum_.resize(3 * image.size()), squares_.resize(3 * image.size());
    for (std::size_t i = 0; i < sum_.size(); ++i) {
        const double value = image.at(i / 3)[static_cast<int>(i % 3)];
        sum_[i] += value, squares_[i] += value * value;
    }
    ++images_;
}

BoundedValue ImageBias::relmse(const ReferenceImage& reference) const {
    if (images_ < 2) return {};
    const double n = static_cast<double>(images_);
    std::vector<double> pixels(reference.pixels());
    for (std::size_t i = 0; i < sum_.size(); ++i) {
        const double a = reference.a()[i], b = reference.b()[i];
        // All pairs, less those of an image with itself.
        const double all = (sum_[i] - n * a) * (sum_[i] - n * b);
        const double same = squares_[i] - (a + b) * sum_[i] + n * a * b;
        pixels[i / 3] += reference.weight()[i] * (all - same) / (n * (n - 1.0)) / 3.0;
    }
    return mean_interval(pixels);
}

}  // namespace ctpbench
