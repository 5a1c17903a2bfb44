// What the builder sorts: boxes in four-wide vectors, with the primitive and its type in the spare lanes.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "accel/vectors.h"
#include "kernels/box.h"

namespace ctpbench {

// A box; the fourth lanes hold nothing.
struct Bounds4 {
    Float4 lo, hi;

    static Bounds4 empty() {
        constexpr float inf = std::numeric_limits<float>::infinity();
        return {Float4{inf, inf, inf, inf}, Float4{-inf, -inf, -inf, -inf}};
    }
    void extend(const Bounds4& b) {
        lo = lower(lo, b.lo);
        hi = upper(hi, b.hi);
    }
    Bounds4 united(const Bounds4& b) const { return {lower(lo, b.lo), upper(hi, b.hi)}; }
    bool is_empty() const { return lo[0] > hi[0] || lo[1] > hi[1] || lo[2] > hi[2]; }
    // Of a box that holds something, or of empty().
    float half_area() const {
        const Float4 e = upper(hi - lo, Float4{});
        const Float4 faces = e * __builtin_shufflevector(e, e, 1, 2, 0, 3);
        return faces[0] + faces[1] + faces[2];
    }
    int longest_axis() const {
        const Float4 e = hi - lo;
        return e[0] >= e[1] ? (e[0] >= e[2] ? 0 : 2) : (e[1] >= e[2] ? 1 : 2);
    }
    Box box() const { return {{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}}; }
};

inline float half_area_of_overlap(const Bounds4& a, const Bounds4& b) {
    const Bounds4 both{upper(a.lo, b.lo), lower(a.hi, b.hi)};
    return both.is_empty() ? 0.0f : both.half_area();
}

// A primitive, or the part of it inside a box: the box, the primitive's number in the source, its type.
struct Reference {
    Float4 lo, hi;

    static Reference make(const Box& b, std::uint32_t primitive, std::uint32_t type) {
        return {Float4{b.lo.x, b.lo.y, b.lo.z, std::bit_cast<float>(primitive)},
                Float4{b.hi.x, b.hi.y, b.hi.z, std::bit_cast<float>(type)}};
    }
    std::uint32_t primitive() const { return std::bit_cast<std::array<std::uint32_t, 4>>(lo)[3]; }
    std::uint32_t type() const { return std::bit_cast<std::array<std::uint32_t, 4>>(hi)[3]; }
    Bounds4 bounds() const { return {lo, hi}; }
    // The same primitive in another box.
    Reference with(const Bounds4& b) const {
        Reference r{b.lo, b.hi};
        r.lo[3] = lo[3];
        r.hi[3] = hi[3];
        return r;
    }
    // Twice the center: as good to compare, without rounding a half.
    Float4 center2() const { return lo + hi; }
};

// Accumulated over the references of a node.
struct Extent {
    Bounds4 box = Bounds4::empty();
    Bounds4 centers = Bounds4::empty();  // of center2()

    void extend(const Reference& r) {
        box.extend(r.bounds());
        centers.extend({r.center2(), r.center2()});
    }
    void extend(const Extent& e) {
        box.extend(e.box);
        centers.extend(e.centers);
    }
};

}  // namespace ctpbench
