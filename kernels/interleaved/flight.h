// Many rays in flight through the 8-wide tree on one thread. Rays wait in lists, by what each does next, and
// a list is worked off in one loop: a step through a node, the test of a block, the clearing of a stack after
// a hit, an end and the start of the next ray. Rays do not wait for each other, so that what one loads or
// computes hides behind the others; and as a ray changes lists by arithmetic, what incoherent rays do next
// is mispredicted neither.
#pragma once

#include <bit>
#include <limits>

#include "../intersect.h"
#include "../simd/float8.h"
#include "leaves.h"
#include "packet.h"
#include "profile.h"

namespace ctpbench {

// What a pass over the rays does with the hits of the pass before.
enum class PassKind : std::uint8_t {
    only,   // there was none
    bound,  // they bound the search
    fresh,  // the search starts afresh, and the nearer hit is kept
};

inline constexpr std::uint32_t kInFlight = 64;
// Steps through nodes are repeated while more rays than these are at nodes: a loop over a short list costs
// more for its end than for its rays.
inline constexpr std::uint32_t kManyAtNodes = kInFlight / 2;
// Rays at most that one call traces.
inline constexpr std::uint32_t kMaxChunk = 4 * kSegment;

template <class Isa, class Methods, class Leaves, class Meter = NoMeter>
class Flight {
    using Blocks = typename Leaves::Blocks;

public:
    Flight(const WideView& tree, const IntersectBuffers& io, PassKind pass, Meter meter = {})
        : tree_(tree), io_(io), pass_(pass), stride_(stack_stride(tree.stack)), meter_(meter) {}

    // Traces the active rays at the positions from begin on to end; or, where the index has segments, those
    // of these segments. First packets of neighbours that are alike, then the others in flight.
    void trace(std::uint32_t begin, std::uint32_t end) {
        meter_.start();
        std::uint32_t rays = 0;
        for_each_range(begin, end, [&](std::uint32_t b, std::uint32_t e) {
            rays += e - b;
            trace_packets(b, e);
        });
        meter_.lap(FlightPhase::packets, rays - left_);
        std::uint32_t active = 0;
        for (std::uint32_t r = 0; r < kInFlight && next_ < left_; ++r, ++active) start(r);
        while (active > 0) {
            do {
                meter_.lap(FlightPhase::nodes, step_through_nodes());
            } while (counts_[kInner] > kManyAtNodes);
            meter_.lap(FlightPhase::blocks,
                       test_blocks(std::make_integer_sequence<std::uint32_t, Leaves::kLists>{}));
            meter_.lap(FlightPhase::stacks, clear_stacks());
            const std::uint32_t ended = counts_[kDone];
            active -= end_rays();
            meter_.lap(FlightPhase::ends, ended);
        }
        if (io_.keys.keys == nullptr && io_.keys.queues.slots == nullptr) return;
        // Rays end in any order; the next stage is told of them in theirs.
        for_each_range(begin, end, [&](std::uint32_t b, std::uint32_t e) {
            for (std::uint32_t i = b; i < e; ++i)
                io_.keys.record(i, io_.index[i], io_.hits.load(io_.index[i]));
        });
    }

private:
    // Numbered as words say what is there.
    static constexpr std::uint32_t kLists = kFirstLeaf + Leaves::kLists;
    using Packets = Packet<Isa, Methods, Leaves>;
    static constexpr std::uint32_t kPacket = Lanes<Isa>::width;

    // A hit as a number: of two, the one that wins is less (Hit::accepts). Positive floats compare like the
    // integers that their bits are.
    struct HitKey {
        std::uint64_t bits;

        CTP_INLINE static HitKey of(float t, std::uint32_t primitive) {
            return {std::uint64_t{std::bit_cast<std::uint32_t>(t)} << 32 | primitive};
        }
        // What no hit is further than: without a limit, an infinite t is none either.
        CTP_INLINE static HitKey bound(float t, std::uint32_t primitive) {
            return of(t, t < std::numeric_limits<float>::infinity() ? primitive : 0u);
        }
        CTP_INLINE float t() const { return std::bit_cast<float>(static_cast<std::uint32_t>(bits >> 32)); }
    };
    struct Found {
        std::uint64_t bits;  // the lane << 32 | the block's word; kDone: none was hit

        CTP_INLINE std::uint32_t word() const { return static_cast<std::uint32_t>(bits); }
        CTP_INLINE std::uint32_t lane() const { return static_cast<std::uint32_t>(bits >> 32); }
    };
    // By arithmetic, for what a compiler would else branch on: mask is all ones or zero.
    template <class T>
    CTP_INLINE static T choose(T mask, T yes, T no) {
        return no ^ ((yes ^ no) & mask);
    }

    struct alignas(64) Ray1 {
        typename Methods::Box::RaySetup box;
        Setups<Blocks> setups;
        HitKey closest;       // so far, or the bound
        Found found;          // the block that was hit
        std::uint32_t word;   // where the ray is
        std::uint32_t top;    // where its stack ends
        std::uint32_t shift;  // of its octant in WideNode::order
        std::uint32_t first_planes[3];
        std::uint32_t slot;
    };
    struct alignas(64) List {
        std::uint8_t rays[kInFlight];
    };

    CTP_INLINE static std::uint32_t list_of(std::uint32_t word) {
        return Leaves::list_of(kind_of_word(word));
    }
    CTP_INLINE void append(std::uint32_t list, std::uint32_t r) {
        lists_[list].rays[counts_[list]++] = static_cast<std::uint8_t>(r);
    }
    // The rays that wait in a list, which is empty afterwards.
    CTP_INLINE std::uint32_t take(std::uint32_t list, List& rays) {
        rays = lists_[list];
        const std::uint32_t n = counts_[list];
        counts_[list] = 0;
        return n;
    }
    CTP_INLINE void go_to(std::uint32_t r, std::uint32_t word) { go_to(r, word, list_of(word)); }
    CTP_INLINE void go_to(std::uint32_t r, std::uint32_t word, std::uint32_t list) {
        rays_[r].word = word;
        const std::byte* at = tree_.bytes + offset_of_word(word);
        prefetch(at), prefetch(at + 64), prefetch(at + 128), prefetch(at + 192);
        append(list, r);
    }

    struct PlanesOfNode {
        const std::byte* node;
        const std::uint32_t* first_planes;

        CTP_INLINE Float8<Isa> at(std::uint32_t offset) const {
            return Float8<Isa>::load(reinterpret_cast<const float*>(node + offset));
        }
        template <int axis>
        CTP_INLINE Float8<Isa> near() const {
            return at(first_planes[axis]);
        }
        template <int axis>
        CTP_INLINE Float8<Isa> far() const {
            return at(first_planes[axis] ^ kOtherPlane);
        }
    };
    // Each of these phases returns for how many rays it was.
    std::uint32_t step_through_nodes() {
        List list;
        const std::uint32_t n = take(kInner, list);
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t r = list.rays[i];
            Ray1& ray = rays_[r];
            const std::byte* node = tree_.bytes + ray.word;
            const auto c =
                Methods::Box::template crossings<Float8<Isa>>(PlanesOfNode{node, ray.first_planes}, ray.box);
            const std::uint32_t top = ray.top +
                                      push_children<Isa>(*reinterpret_cast<const WideNode*>(node), c.near(),
                                                         c.far(Float8<Isa>(ray.closest.t())), ray.shift,
                                                         words_ + ray.top, nears_ + ray.top) -
                                      1;
            ray.top = top;
            go_to(r, words_[top]);
        }
        return n;
    }

    template <std::uint32_t... lists>
    CTP_INLINE std::uint32_t test_blocks(std::integer_sequence<std::uint32_t, lists...>) {
        return (test_blocks_of<lists>() + ...);
    }
    template <std::uint32_t leaf_list>
    std::uint32_t test_blocks_of() {
        List list;
        const std::uint32_t n = take(kFirstLeaf + leaf_list, list);
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t r = list.rays[i];
            Ray1& ray = rays_[r];
            const std::uint32_t word = ray.word;
            const BlockHit h =
                Leaves::template test<Isa, leaf_list>(tree_.bytes + offset_of_word(word), word, ray.setups);
            const HitKey candidate = HitKey::of(h.t, h.id);
            const std::uint64_t hit = -std::uint64_t{candidate.bits < ray.closest.bits};
            ray.closest.bits = choose(hit, candidate.bits, ray.closest.bits);
            ray.found.bits = choose(hit, std::uint64_t{h.lane} << 32 | word, ray.found.bits);
            const auto hit32 = static_cast<std::uint32_t>(hit);
            const std::uint32_t last = -std::uint32_t{more_blocks(word) == 0};
            ray.top += last & ~hit32;
            const std::uint32_t next = choose(hit32, word, choose(last, words_[ray.top], after(word)));
            go_to(r, next, choose(hit32, kHit, list_of(next)));
        }
        return n;
    }
    // The leaf's next block.
    CTP_INLINE static std::uint32_t after(std::uint32_t word) {
        return word + Leaves::stride(word) - kOneBlock;
    }

    // What lies beyond a hit leaves the stack at once, so that whatever is taken from it need not be asked.
    std::uint32_t clear_stacks() {
        List list;
        const std::uint32_t n = take(kHit, list);
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t r = list.rays[i];
            Ray1& ray = rays_[r];
            const std::uint32_t bottom = r * stride_;
            const std::uint32_t top =
                bottom + keep_near<Isa>(words_ + bottom, nears_ + bottom, ray.top - bottom, ray.closest.t());
            const bool stays = more_blocks(ray.word) != 0;
            ray.top = top - !stays;
            go_to(r, stays ? after(ray.word) : words_[top - 1]);
        }
        return n;
    }

    // Returns how many rays have ended without another one to follow.
    std::uint32_t end_rays() {
        List list;
        const std::uint32_t n = take(kDone, list);
        std::uint32_t gone = 0;
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t r = list.rays[i];
            finish(rays_[r]);
            if (next_ < left_)
                start(r);
            else
                ++gone;
        }
        return gone;
    }
    CTP_INLINE void finish(const Ray1& ray) {
        const bool hit = ray.found.word() != kDone;
        Hit closest = hit ? Leaves::template resolve<Isa>(tree_.bytes + offset_of_word(ray.found.word()),
                                                          ray.found.word(), ray.found.lane(), ray.closest.t(),
                                                          ray.setups)
                          : Hit{ray.closest.t(), kNoPrimitive, 0.0f, 0.0f};
        if (!hit && pass_ == PassKind::bound) return;  // what was before is still there
        conclude(ray.slot, closest);
    }
    CTP_INLINE void conclude(std::uint32_t slot, Hit closest) const {
        if (pass_ == PassKind::fresh) {
            const Hit before = io_.hits.load(slot);
            if (before.primitive != kNoPrimitive && !before.accepts(closest.t, closest.primitive))
                closest = before;
        }
        io_.hits.store(slot, closest);
    }

    template <class F>
    CTP_INLINE void for_each_range(std::uint32_t begin, std::uint32_t end, F&& f) const {
        if (io_.segment_counts == nullptr) return f(begin, end);
        for (std::uint32_t s = begin; s < end; ++s) f(s * kSegment, s * kSegment + io_.segment_counts[s]);
    }
    // Traces neighbours together where they are alike, and leaves the others.
    void trace_packets(std::uint32_t begin, std::uint32_t end) {
        std::uint32_t i = begin;
        if constexpr (kPacket > 0) {
            for (; i + kPacket <= end; i += kPacket)
                if (!trace_packet(i)) leave(i, i + kPacket);
        }
        leave(i, end);
    }
    CTP_INLINE void leave(std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t i = begin; i < end; ++i) positions_[left_++] = i;
    }
    bool trace_packet(std::uint32_t first) {
        Ray rays[kPacket];
        const auto load = [&](std::uint32_t i) { rays[i] = io_.rays.load(io_.index[first + i]); };
        load(0), load(kPacket - 1);  // neighbours that differ mostly differ here
        if (!Packets::alike(rays[0], rays[kPacket - 1], io_.extent)) return false;
        for (std::uint32_t i = 1; i + 1 < kPacket; ++i) {
            load(i);
            if (!Packets::alike(rays[0], rays[i], io_.extent)) return false;
        }
        Packets packet;
        if (!packet.set(rays, io_.extent)) return false;
        Hit hits[kPacket];
        for (std::uint32_t i = 0; i < kPacket; ++i)
            hits[i] = pass_ == PassKind::bound ? io_.hits.load(io_.index[first + i]) : no_hit(rays[i]);
        packet.trace(tree_, hits);
        for (std::uint32_t i = 0; i < kPacket; ++i) conclude(io_.index[first + i], hits[i]);
        return true;
    }

    CTP_INLINE void start(std::uint32_t r) {
        Ray1& f = rays_[r];
        f.slot = io_.index[positions_[next_++]];
        const Ray ray = io_.rays.load(f.slot);
        f.box = Methods::Box::setup(ray, io_.extent);
        for_each_type(Blocks{}, [&](auto tag) {
            using Block = typename decltype(tag)::type;
            f.setups.template of<Block>() = Block::setup(ray);
        });
        f.closest = pass_ == PassKind::bound ? HitKey::bound(io_.hits.t[f.slot], io_.hits.primitive[f.slot])
                                             : HitKey::bound(ray.tmax, kNoPrimitive);
        f.found.bits = kDone;
        const bool negative[3] = {f.box.ix < 0.0f, f.box.iy < 0.0f, f.box.iz < 0.0f};
        f.shift = 0;
        for (std::uint32_t axis = 0; axis < 3; ++axis) {
            f.first_planes[axis] = first_plane(axis, negative[axis]);
            f.shift += negative[axis] ? 3u << axis : 0u;
        }
        f.top = r * stride_;
        words_[f.top] = kDone;
        nears_[f.top++] = -std::numeric_limits<float>::infinity();
        go_to(r, tree_.root);
    }

    const WideView tree_;
    const IntersectBuffers io_;
    const PassKind pass_;
    const std::uint32_t stride_;
    [[no_unique_address]] Meter meter_;
    std::uint32_t next_ = 0, left_ = 0;  // of positions_: the rays to come
    std::uint32_t counts_[kLists] = {};
    List lists_[kLists];
    Ray1 rays_[kInFlight];
    std::uint32_t positions_[kMaxChunk];
    alignas(64) std::uint32_t words_[kInFlight * stack_stride(kMaxStack)];
    alignas(64) float nears_[kInFlight * stack_stride(kMaxStack)];
};

}  // namespace ctpbench
