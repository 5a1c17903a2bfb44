// Matte materials of synthetic types: an albedo in a unit of its own, and random numbers of their own, so
// that nothing that two of them compute is the same.
#pragma once

#include "../materials/description.h"
#include "../materials/scattering.h"
#include "../surface.h"
#include "types.h"

namespace ctpbench {

namespace detail {
// "synthetic_7"
template <int number>
struct SyntheticName {
    static constexpr auto make() {
        std::array<char, 16> text{'s', 'y', 'n', 't', 'h', 'e', 't', 'i', 'c', '_'};
        std::size_t at = 10;
        if (number >= 10) text[at++] = static_cast<char>('0' + number / 10);
        text[at] = static_cast<char>('0' + number % 10);
        return text;
    }
    static constexpr std::array<char, 16> text = make();
};
}  // namespace detail

template <int number, bool large>
struct SyntheticMatte : Ballast<large> {
    static constexpr const char* name = detail::SyntheticName<number>::text.data();
    static constexpr float unit = synthetic_unit<number>;

    Vec3 albedo;  // in units

    static SyntheticMatte make(const MaterialDescription& d) {
        SyntheticMatte m{};
        m.albedo = d.diffuse * (1.0f / unit);
        return m;
    }

    CTP_INLINE Scattering sample(const SurfacePoint& point, const PathRandom& random) const {
        PathRandom own = random;
        own.seed ^= std::uint64_t{number + 1} << 40;
        const Random4 r = own.draw();
        return scattered(cosine_direction(point.normal, r.v[0], r.v[1]), albedo * unit);
    }
};

template <int listed, bool large>
using SyntheticMaterials = SyntheticList<SyntheticMatte, listed, large>;

}  // namespace ctpbench
