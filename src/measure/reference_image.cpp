#include "measure/reference_image.h"

namespace ctpbench {

ReferenceImage::ReferenceImage(const ImageStorage& a, const ImageStorage& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (int channel = 0; channel < 3; ++channel) {
            a_.push_back(a.at(i)[channel]), b_.push_back(b.at(i)[channel]);
            const double mean = 0.5 * (a_.back() + b_.back());
            weight_.push_back(1.0 / (mean * mean + kDarkness));
        }
    }
}

double ReferenceImage::relmse(const ImageStorage& image) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < a_.size(); ++i) {
        const double value = image.at(i / 3)[static_cast<int>(i % 3)];
        sum += weight_[i] * (value - a_[i]) * (value - b_[i]);
    }
    return sum / static_cast<double>(a_.size());
}

double ReferenceImage::noise() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < a_.size(); ++i) {
        const double difference = 0.5 * (a_[i] - b_[i]);
        sum += weight_[i] * difference * difference;
    }
    return sum / static_cast<double>(a_.size());
}

}  // namespace ctpbench
