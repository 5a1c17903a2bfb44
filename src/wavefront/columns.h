// Host storage behind the wavefront's column views.
#pragma once

#include <vector>

#include "kernels/wavefront.h"

namespace ctpbench {

class RayStorage {
public:
    void resize(std::size_t n) {
        for (auto& c : columns_) c.resize(n);
    }
    std::size_t size() const { return columns_[0].size(); }
    RayColumns view() {
        return {columns_[0].data(), columns_[1].data(), columns_[2].data(), columns_[3].data(),
                columns_[4].data(), columns_[5].data(), columns_[6].data()};
    }

private:
    std::vector<float> columns_[7];
};

class HitStorage {
public:
    void resize(std::size_t n) { t_.resize(n), primitive_.resize(n), u_.resize(n), v_.resize(n); }
    std::size_t size() const { return t_.size(); }
    HitColumns view() { return {t_.data(), primitive_.data(), u_.data(), v_.data()}; }
    // XXH3 over all columns: equal for bit-identical hits only.
    std::uint64_t hash() const;

private:
    std::vector<float> t_;
    std::vector<std::uint32_t> primitive_;
    std::vector<float> u_, v_;
};

class PixelStorage {
public:
    void resize(std::size_t n) {
        for (auto& c : columns_) c.resize(n);
    }
    PixelColumns view() {
        return {columns_[0].data(), columns_[1].data(), columns_[2].data(),
                columns_[3].data(), columns_[4].data(), columns_[5].data()};
    }

private:
    std::vector<float> columns_[6];
};

}  // namespace ctpbench
