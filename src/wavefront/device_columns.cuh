// The wavefront's columns in a device's memory.
#pragma once

#include <array>

#include "backends/device_array.cuh"
#include "kernels/wavefront.h"
#include "wavefront/columns.h"

namespace ctpbench {

// N columns of one length in one allocation.
template <class T, std::size_t N>
class DeviceColumns {
public:
    DeviceColumns() = default;
    explicit DeviceColumns(std::size_t n) : size_(n), data_(n * N) {}

    T* column(std::size_t i) const { return data_.data() + i * size_; }
    std::size_t size() const { return size_; }
    std::size_t bytes() const { return data_.bytes(); }

private:
    std::size_t size_ = 0;
    DeviceArray<T> data_;
};

class DeviceRays : public DeviceColumns<float, 7> {
public:
    using DeviceColumns::DeviceColumns;
    RayColumns view() const {
        return {column(0), column(1), column(2), column(3), column(4), column(5), column(6)};
    }
};

class DevicePixels : public DeviceColumns<float, 6> {
public:
    using DeviceColumns::DeviceColumns;
    PixelColumns view() const { return {column(0), column(1), column(2), column(3), column(4), column(5)}; }
};

class DeviceImage : public DeviceColumns<float, 3> {
public:
    using DeviceColumns::DeviceColumns;
    ImageColumns view() const { return {column(0), column(1), column(2)}; }
};

class DeviceHits {
public:
    DeviceHits() = default;
    explicit DeviceHits(std::size_t n) : floats_(n), primitive_(n) {}
    HitColumns view() const {
        return {floats_.column(0), primitive_.data(), floats_.column(1), floats_.column(2)};
    }
    std::size_t size() const { return primitive_.size(); }

private:
    DeviceColumns<float, 3> floats_;
    DeviceArray<std::uint32_t> primitive_;
};

// Column by column, of the first n entries; either side may be the device's.
template <class T>
void copy_column(T* to, const T* from, std::size_t n) {
    if (n > 0) check_cuda(cudaMemcpy(to, from, n * sizeof(T), cudaMemcpyDefault), "copying a column");
}
inline void copy_columns(const RayColumns& to, const RayColumns& from, std::size_t n) {
    copy_column(to.ox, from.ox, n), copy_column(to.oy, from.oy, n), copy_column(to.oz, from.oz, n);
    copy_column(to.dx, from.dx, n), copy_column(to.dy, from.dy, n), copy_column(to.dz, from.dz, n);
    copy_column(to.tmax, from.tmax, n);
}
inline void copy_columns(const HitColumns& to, const HitColumns& from, std::size_t n) {
    copy_column(to.t, from.t, n), copy_column(to.primitive, from.primitive, n);
    copy_column(to.u, from.u, n), copy_column(to.v, from.v, n);
}
inline void copy_columns(const ImageColumns& to, const ImageColumns& from, std::size_t n) {
    copy_column(to.r, from.r, n), copy_column(to.g, from.g, n), copy_column(to.b, from.b, n);
}

}  // namespace ctpbench
