// Host storage behind the wavefront's column views, in huge pages where the system grants them: a path's data
// lie in some twenty columns.
#pragma once

#include <array>
#include <cstdint>

#include "kernels/array.h"
#include "kernels/wavefront.h"

namespace ctpbench {

// N columns of floats of one length.
template <std::size_t N>
class FloatColumns {
public:
    void resize(std::size_t n) {
        for (auto& c : columns_) c.resize(n);
    }
    std::size_t size() const { return columns_[0].size(); }

protected:
    std::array<Array<float>, N> columns_;
};

class RayStorage : public FloatColumns<7> {
public:
    RayColumns view() {
        auto& c = columns_;
        return {c[0].data(), c[1].data(), c[2].data(), c[3].data(), c[4].data(), c[5].data(), c[6].data()};
    }
};

class HitStorage {
public:
    void resize(std::size_t n) { t_.resize(n), primitive_.resize(n), u_.resize(n), v_.resize(n); }
    std::size_t size() const { return t_.size(); }
    HitColumns view() { return {t_.data(), primitive_.data(), u_.data(), v_.data()}; }
    // XXH3 over all columns: equal for bit-identical hits only.
    std::uint64_t hash() const;

private:
    Array<float> t_;
    Array<std::uint32_t> primitive_;
    Array<float> u_, v_;
};

class PixelStorage : public FloatColumns<6> {
public:
    PixelColumns view() {
        auto& c = columns_;
        return {c[0].data(), c[1].data(), c[2].data(), c[3].data(), c[4].data(), c[5].data()};
    }
};

class ImageStorage : public FloatColumns<3> {
public:
    ImageColumns view() { return {columns_[0].data(), columns_[1].data(), columns_[2].data()}; }
    Vec3 at(std::size_t i) const { return {columns_[0][i], columns_[1][i], columns_[2][i]}; }
    std::uint64_t hash() const;
};

}  // namespace ctpbench
