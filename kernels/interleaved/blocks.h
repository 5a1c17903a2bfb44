// Blocks of four primitives of one type, tested together: what leaves of the 8-wide tree hold. The tests are
// the methods' own, over packs, so that hits are the scalar ones bit for bit.
#pragma once

#include <bit>
#include <limits>

#include "../primitives/list.h"
#include "../simd/float4.h"
#include "packet_rays.h"

namespace ctpbench {

// Ids rise along a block's lanes; what is missing to four repeats the last.
inline constexpr std::uint32_t kBlock = 4;

// The nearest of a block's hits, of equals the one with the lowest id; t is infinite if there is none.
struct BlockHit {
    float t;
    std::uint32_t lane, id;
};

// Lanes that do not hit, or not in front of the origin, are infinitely far.
template <class Isa>
CTP_INLINE BlockHit nearest(Float4<Isa> t, Mask4<Isa> hits, const std::uint32_t* ids) {
    using F = Float4<Isa>;
    const F none(std::numeric_limits<float>::infinity());
    const F candidates = select(hits & (F(0.0f) < t), t, none);
    const F closest = least(candidates);
    const auto lane = static_cast<std::uint32_t>(std::countr_zero((candidates == closest).bits()));
    return {closest.first(), lane, ids[lane]};
}

template <class Methods>
struct alignas(32) TriangleBlock {
    using Primitive = Triangle<Methods>;
    using Test = typename Methods::Triangle;
    using Setup = typename Test::RaySetup;

    float vertex[3][3][kBlock];  // by vertex and axis
    std::uint32_t id[kBlock];

    CTP_INLINE static Setup setup(const Ray& ray) { return Test::setup(ray); }
    void set(std::uint32_t lane, const GeometryView& g, std::uint32_t index) {
        const typename Test::Shape shape = Test::shape(g.triangle(index));
        for (int v = 0; v < 3; ++v)
            for (int a = 0; a < 3; ++a) vertex[v][a][lane] = shape.vertex[v][a];
        id[lane] = index;
    }
    CTP_INLINE typename Test::Shape shape(std::uint32_t lane) const {
        typename Test::Shape s;
        for (int v = 0; v < 3; ++v)
            for (int a = 0; a < 3; ++a) s.vertex[v][a] = vertex[v][a][lane];
        return s;
    }

    template <class Isa>
    CTP_INLINE BlockHit intersect(const Setup& r) const {
        using F = Float4<Isa>;
        const auto e = Test::template edges<F>([&](int v, int axis) { return F::load(vertex[v][axis]); }, r);
        const F zero(0.0f);
        const auto inside = !((min(min(e.u, e.v), e.w) < zero) & (zero < max(max(e.u, e.v), e.w)));
        const F det = (e.u + e.v) + e.w;
        const auto covered = inside & !(det == zero);
        F t = Test::t_of(e, F(1.0f) / det, r);
        const F error = Test::doubt(e, r);
        const std::uint32_t doubtful = (covered & (absolute(t) <= error)).bits();
        if (doubtful != 0) t = refined(r, t, error, doubtful);
        return nearest<Isa>(t, covered, id);
    }
    // Setup of a packet. Its rays have the same axes.
    template <class F>
    struct LaneSetup {
        int kx, ky, kz;
        F ox, oy, oz, sx, sy, sz;

        template <class G>
        CTP_INLINE bool gather(const Setup* rays) {
            kx = rays[0].kx, ky = rays[0].ky, kz = rays[0].kz;
            ox = gathered<G>(rays, [](const Setup& r) { return r.ox; });
            oy = gathered<G>(rays, [](const Setup& r) { return r.oy; });
            oz = gathered<G>(rays, [](const Setup& r) { return r.oz; });
            sx = gathered<G>(rays, [](const Setup& r) { return r.sx; });
            sy = gathered<G>(rays, [](const Setup& r) { return r.sy; });
            sz = gathered<G>(rays, [](const Setup& r) { return r.sz; });
            bool same = true;
            for (std::uint32_t i = 1; i < G::width; ++i) same &= rays[i].kz == kz;
            return same;
        }
    };
    template <class Isa>
    CTP_INLINE void intersect_packet(const PacketSetup<Isa, TriangleBlock>& setup,
                                     PacketHits<Isa>& hits) const {
        using F = Lanes<Isa>;
        const F zero(0.0f);
        for (std::uint32_t i = 0; i < kBlock && (i == 0 || id[i] != id[i - 1]); ++i) {
            const auto e =
                Test::template edges<F>([&](int v, int axis) { return F(vertex[v][axis][i]); }, setup.lanes);
            const auto inside = !((min(min(e.u, e.v), e.w) < zero) & (zero < max(max(e.u, e.v), e.w)));
            const F det = (e.u + e.v) + e.w;
            const auto covered = inside & !(det == zero);
            if (covered.bits() == 0) continue;
            const F inv = F(1.0f) / det;
            F t = Test::t_of(e, inv, setup.lanes);
            const F error = Test::doubt(e, setup.lanes);
            const std::uint32_t doubtful = (covered & (absolute(t) <= error)).bits();
            if (doubtful != 0) t = refined<F>(i, setup.rays, t, error, doubtful);
            hits.offer(covered, t, id[i], e.v * inv, e.w * inv);
        }
    }

    // All there is to a hit on this lane at t: what intersect() of the primitive would give.
    CTP_INLINE Hit resolve(std::uint32_t lane, float t, const Setup& r) const {
        const auto e = Test::template edges<float>([&](int v, int axis) { return vertex[v][axis][lane]; }, r);
        const float inv = 1.0f / ((e.u + e.v) + e.w);
        return {t, id[lane], e.v * inv, e.w * inv};
    }

private:
    template <class F>
    CTP_INLINE F refined(std::uint32_t lane, const Setup* rays, F t, F error, std::uint32_t doubtful) const {
        float ts[F::width], errors[F::width];
        t.store(ts);
        error.store(errors);
        for (; doubtful != 0; doubtful &= doubtful - 1) {
            const int i = std::countr_zero(doubtful);
            ts[i] = Test::refined_t(shape(lane), rays[i], ts[i] - errors[i], ts[i] + errors[i]);
        }
        return F::load(ts);
    }
    template <class Isa>
    CTP_INLINE Float4<Isa> refined(const Setup& r, Float4<Isa> t, Float4<Isa> error,
                                   std::uint32_t doubtful) const {
        float ts[kBlock], errors[kBlock];
        t.store(ts);
        error.store(errors);
        for (std::uint32_t lane = 0; lane < kBlock; ++lane)
            if (doubtful >> lane & 1u)
                ts[lane] = Test::refined_t(shape(lane), r, ts[lane] - errors[lane], ts[lane] + errors[lane]);
        return Float4<Isa>::load(ts);
    }
};

template <class Methods>
struct alignas(32) SphereBlock {
    using Primitive = Sphere<Methods>;
    using Test = typename Methods::Sphere;
    using Setup = typename Test::RaySetup;

    float x[kBlock], y[kBlock], z[kBlock], radius[kBlock];
    std::uint32_t id[kBlock];

    CTP_INLINE static Setup setup(const Ray& ray) { return Test::setup(ray); }
    void set(std::uint32_t lane, const GeometryView& g, std::uint32_t index) {
        const typename Test::Shape s = Test::shape(g.spheres[index]);
        x[lane] = s.center.x, y[lane] = s.center.y, z[lane] = s.center.z, radius[lane] = s.radius;
        id[lane] = g.first_sphere() + index;
    }

    template <class Isa>
    CTP_INLINE BlockHit intersect(const Setup& r) const {
        using F = Float4<Isa>;
        const auto e = Test::template quadratic<F>(F::load(x), F::load(y), F::load(z), F::load(radius), r);
        // The root of a negative number is NaN, and is not positive.
        return nearest<Isa>(Test::t_of(e, r), F(0.0f) <= e.discriminant, id);
    }
    template <class F>
    struct LaneSetup {
        struct Vector {
            F x, y, z;
        };
        struct {
            Vector origin, direction;
        } ray;
        F length, inv_dd;

        template <class G>
        CTP_INLINE bool gather(const Setup* rays) {
            ray.origin.x = gathered<G>(rays, [](const Setup& r) { return r.ray.origin.x; });
            ray.origin.y = gathered<G>(rays, [](const Setup& r) { return r.ray.origin.y; });
            ray.origin.z = gathered<G>(rays, [](const Setup& r) { return r.ray.origin.z; });
            ray.direction.x = gathered<G>(rays, [](const Setup& r) { return r.ray.direction.x; });
            ray.direction.y = gathered<G>(rays, [](const Setup& r) { return r.ray.direction.y; });
            ray.direction.z = gathered<G>(rays, [](const Setup& r) { return r.ray.direction.z; });
            length = gathered<G>(rays, [](const Setup& r) { return r.length; });
            inv_dd = gathered<G>(rays, [](const Setup& r) { return r.inv_dd; });
            return true;
        }
    };
    template <class Isa>
    CTP_INLINE void intersect_packet(const PacketSetup<Isa, SphereBlock>& setup,
                                     PacketHits<Isa>& hits) const {
        using F = Lanes<Isa>;
        for (std::uint32_t i = 0; i < kBlock && (i == 0 || id[i] != id[i - 1]); ++i) {
            const auto e = Test::template quadratic<F>(F(x[i]), F(y[i]), F(z[i]), F(radius[i]), setup.lanes);
            const auto met = F(0.0f) <= e.discriminant;
            if (met.bits() == 0) continue;
            hits.offer(met, Test::t_of(e, setup.lanes), id[i], F(0.0f), F(0.0f));
        }
    }

    CTP_INLINE Hit resolve(std::uint32_t lane, float t, const Setup&) const {
        return {t, id[lane], 0.0f, 0.0f};
    }
};

namespace detail {
template <class Primitive>
struct BlockOf;
template <class Methods>
struct BlockOf<Triangle<Methods>> {
    using type = TriangleBlock<Methods>;
};
template <class Methods>
struct BlockOf<Sphere<Methods>> {
    using type = SphereBlock<Methods>;
};
template <class List>
struct BlocksOf;
template <class... Ts>
struct BlocksOf<TypeList<Ts...>> {
    using type = TypeList<typename BlockOf<Ts>::type...>;
};
}  // namespace detail

// The blocks of a list of primitives, in its order.
template <class Types>
using BlocksOf = typename detail::BlocksOf<Types>::type;

}  // namespace ctpbench
