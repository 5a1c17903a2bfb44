// A packet of rays that go the same way, one ray a lane: each node and each primitive is fetched once for all
// of them. Whether rays are alike enough is measured on them, so nobody has to know where they come from.
//
// Wald, Slusallek, Benthin & Wagner, "Interactive Rendering with Coherent Ray Tracing", Eurographics 2001.
#pragma once

#include <limits>

#include "../intersect.h"
#include "leaves.h"
#include "wide_view.h"

namespace ctpbench {

template <class Isa, class Methods, class Leaves>
class Packet {
    using F = Lanes<Isa>;
    using Blocks = typename Leaves::Blocks;

public:
    static constexpr std::uint32_t kWidth = F::width;

    // Whether two rays may be in one packet: what one of them visits the other is likely to visit too. That
    // steers speed alone.
    CTP_INLINE static bool alike(const Ray& a, const Ray& b, float extent) {
        const Vec3 d = a.direction, e = b.direction;
        const float most = max(max(absolute(d.x), absolute(d.y)), absolute(d.z));
        const float apart = max(max(absolute(d.x - e.x), absolute(d.y - e.y)), absolute(d.z - e.z));
        const Vec3 o = a.origin - b.origin;
        return apart <= kSlope * most &&
               max(max(absolute(o.x), absolute(o.y)), absolute(o.z)) <= kDistance * extent &&
               (d.x < 0.0f) == (e.x < 0.0f) && (d.y < 0.0f) == (e.y < 0.0f) && (d.z < 0.0f) == (e.z < 0.0f);
    }

    // Takes rays that are alike; false if they cannot be traced together all the same.
    bool set(const Ray* rays, float extent) {
        typename Methods::Box::RaySetup boxes[kWidth];
        for (std::uint32_t i = 0; i < kWidth; ++i) boxes[i] = Methods::Box::setup(rays[i], extent);
        using Setup = typename Methods::Box::RaySetup;
        box_.ix = gathered<F>(boxes, [](const Setup& s) { return s.ix; });
        box_.iy = gathered<F>(boxes, [](const Setup& s) { return s.iy; });
        box_.iz = gathered<F>(boxes, [](const Setup& s) { return s.iz; });
        box_.near_x = gathered<F>(boxes, [](const Setup& s) { return s.near_x; });
        box_.near_y = gathered<F>(boxes, [](const Setup& s) { return s.near_y; });
        box_.near_z = gathered<F>(boxes, [](const Setup& s) { return s.near_z; });
        box_.far_x = gathered<F>(boxes, [](const Setup& s) { return s.far_x; });
        box_.far_y = gathered<F>(boxes, [](const Setup& s) { return s.far_y; });
        box_.far_z = gathered<F>(boxes, [](const Setup& s) { return s.far_z; });
        negative_[0] = boxes[0].ix < 0.0f, negative_[1] = boxes[0].iy < 0.0f,
        negative_[2] = boxes[0].iz < 0.0f;
        return rays_.set(rays);
    }

    // `hits`: of each ray the nearest one so far, or its bound; the nearest one of all afterwards.
    void trace(const WideView& tree, Hit* hits) {
        PacketHits<Isa>& best = rays_.hits;
        best.t = gathered<F>(hits, [](const Hit& h) { return h.t; });
        best.u = gathered<F>(hits, [](const Hit& h) { return h.u; });
        best.v = gathered<F>(hits, [](const Hit& h) { return h.v; });
        best.primitive = gathered<F>(hits, [](const Hit& h) { return std::bit_cast<float>(h.primitive); });
        const std::uint32_t shift = 3 * (negative_[0] + 2 * negative_[1] + 4 * negative_[2]);
        words_[0] = tree.root;
        nears_[0] = F(0.0f);
        for (std::uint32_t top = 1; top > 0;) {
            --top;
            if ((nears_[top] <= best.t).bits() == 0) continue;
            const std::uint32_t word = words_[top];
            const std::byte* at = tree.bytes + offset_of_word(word);
            if (kind_of_word(word) == kInner)
                top = push_children(block_at<WideNode>(at), shift, best.t, top);
            else
                Leaves::template test_packet<Isa>(at, word, rays_);
        }
        alignas(64) float t[kWidth], u[kWidth], v[kWidth], primitive[kWidth];
        best.t.store(t), best.u.store(u), best.v.store(v), best.primitive.store(primitive);
        for (std::uint32_t i = 0; i < kWidth; ++i)
            hits[i] = {t[i], std::bit_cast<std::uint32_t>(primitive[i]), u[i], v[i]};
    }

private:
    static constexpr float kSlope = 1.0f / 16, kDistance = 1.0f / 128;

    struct BoxSetup {
        F ix, iy, iz, near_x, near_y, near_z, far_x, far_y, far_z;
    };
    struct PlanesOfChild {
        const WideNode& node;
        const std::uint32_t* negative;
        std::uint32_t child;
        template <int axis>
        CTP_INLINE F near() const {
            return F(node.bounds[axis][negative[axis]][child]);
        }
        template <int axis>
        CTP_INLINE F far() const {
            return F(node.bounds[axis][1 - negative[axis]][child]);
        }
    };
    // The nearest child comes to lie on top. Rays that miss a child have no number for its distance.
    CTP_INLINE std::uint32_t push_children(const WideNode& node, std::uint32_t shift, F t,
                                           std::uint32_t top) {
        const F never(std::numeric_limits<float>::quiet_NaN());
        for (std::uint32_t i = 0; i < kWide; ++i) {
            const std::uint32_t child = node.order[i] >> shift & 7u;
            const auto c = Methods::Box::template crossings<F>(PlanesOfChild{node, negative_, child}, box_);
            const F near = c.near();
            const auto met = near <= c.far(t);
            words_[top] = node.children[child];
            nears_[top] = select(met, near, never);
            top += met.bits() != 0;
        }
        return top;
    }

    PacketRays<Isa, Blocks> rays_;
    BoxSetup box_;
    std::uint32_t negative_[3];
    F nears_[kMaxStack];
    std::uint32_t words_[kMaxStack];
};

}  // namespace ctpbench
