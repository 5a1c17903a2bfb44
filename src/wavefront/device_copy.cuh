// Copies of columns between a device and the host; either side may be either's.
#pragma once

#include "backends/cuda_check.cuh"
#include "kernels/wavefront.h"

namespace ctpbench {

// The first n entries.
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
