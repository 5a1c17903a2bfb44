// The rays of a packet as blocks of primitives see them: what their tests derive from each ray, one ray a
// lane, and the nearest hits so far.
#pragma once

#include <bit>
#include <limits>

#include "../ray.h"
#include "../simd/lanes.h"
#include "../type_list.h"

namespace ctpbench {

template <class Isa>
struct PacketHits {
    using F = Lanes<Isa>;
    static constexpr std::uint32_t kWidth = F::width;

    F t, u, v;
    F primitive;  // its bits

    // A candidate on the lanes of the mask, on each the same primitive; takes it where Hit::accepts would.
    CTP_INLINE void offer(typename F::Mask lanes, F candidate, std::uint32_t id, F candidate_u,
                          F candidate_v) {
        auto taken = lanes & (F(0.0f) < candidate) & (candidate < t);
        const auto equal = lanes & (F(0.0f) < candidate) & (candidate == t) &
                           (candidate < F(std::numeric_limits<float>::infinity()));
        if (equal.bits() != 0) offer_equal(equal.bits(), id, candidate_u, candidate_v);
        t = select(taken, candidate, t);
        u = select(taken, candidate_u, u), v = select(taken, candidate_v, v);
        primitive = select(taken, F(std::bit_cast<float>(id)), primitive);
    }

private:
    CTP_INLINE void offer_equal(std::uint32_t lanes, std::uint32_t id, F candidate_u, F candidate_v) {
        float from_u[kWidth], from_v[kWidth], us[kWidth], vs[kWidth], ids[kWidth];
        candidate_u.store(from_u), candidate_v.store(from_v);
        u.store(us), v.store(vs), primitive.store(ids);
        for (; lanes != 0; lanes &= lanes - 1) {
            const int lane = std::countr_zero(lanes);
            if (id >= std::bit_cast<std::uint32_t>(ids[lane])) continue;
            us[lane] = from_u[lane], vs[lane] = from_v[lane], ids[lane] = std::bit_cast<float>(id);
        }
        u = F::load(us), v = F::load(vs), primitive = F::load(ids);
    }
};

// For blocks of one type.
template <class Isa, class Block>
struct PacketSetup {
    typename Block::template LaneSetup<Lanes<Isa>> lanes;
    typename Block::Setup rays[Lanes<Isa>::width];
};

namespace detail {
template <class Isa>
struct PacketSetupIn {
    template <class Block>
    using Of = PacketSetup<Isa, Block>;
};
}  // namespace detail

template <class Isa, class Blocks>
struct PacketRays {
    PerType<detail::PacketSetupIn<Isa>::template Of, Blocks> setups;
    PacketHits<Isa> hits;

    // Whether blocks can test these rays together.
    CTP_INLINE bool set(const Ray* rays) {
        bool together = true;
        for_each_type(Blocks{}, [&](auto tag) {
            using Block = typename decltype(tag)::type;
            auto& setup = setups.template of<Block>();
            for (std::uint32_t i = 0; i < Lanes<Isa>::width; ++i) setup.rays[i] = Block::setup(rays[i]);
            together &= setup.lanes.template gather<Lanes<Isa>>(setup.rays);
        });
        return together;
    }
    template <class Block>
    CTP_INLINE void test(const Block& block) {
        block.template intersect_packet<Isa>(setups.template of<Block>(), hits);
    }
};

// The floats at `member` of each ray's setup.
template <class F, class Setup, class Member>
CTP_INLINE F gathered(const Setup* rays, Member&& member) {
    alignas(64) float values[F::width];
    for (std::uint32_t i = 0; i < F::width; ++i) values[i] = member(rays[i]);
    return F::load(values);
}

}  // namespace ctpbench
