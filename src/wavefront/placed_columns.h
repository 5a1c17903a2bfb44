// The wavefront's columns in a place's memory, the floats of each kind in one piece.
#pragma once

#include "kernels/wavefront.h"

namespace ctpbench {

template <class Place>
RayColumns rays_in(const Place& place, std::size_t n) {
    float* c = place.template reserve<float>(7 * n);
    return {c, c + n, c + 2 * n, c + 3 * n, c + 4 * n, c + 5 * n, c + 6 * n};
}

template <class Place>
HitColumns hits_in(const Place& place, std::size_t n) {
    float* c = place.template reserve<float>(3 * n);
    return {c, place.template reserve<std::uint32_t>(n), c + n, c + 2 * n};
}

template <class Place>
PixelColumns pixels_in(const Place& place, std::size_t n) {
    float* c = place.template reserve<float>(6 * n);
    return {c, c + n, c + 2 * n, c + 3 * n, c + 4 * n, c + 5 * n};
}

template <class Place>
ImageColumns image_in(const Place& place, std::size_t n) {
    float* c = place.template reserve<float>(3 * n);
    return {c, c + n, c + 2 * n};
}

}  // namespace ctpbench
