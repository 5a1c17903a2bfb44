// Puts a node's references to its two sides, out of place and in a fixed order.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "accel/parallel.h"
#include "accel/reference.h"

namespace ctpbench {

// Receives the references of one side.
struct Side {
    Reference* out = nullptr;
    std::uint32_t count = 0;
    Extent extent;

    void put(const Reference& r) {
        out[count++] = r;
        extent.extend(r);
    }
};

// Counts references instead.
struct Count {
    std::uint32_t count = 0;

    void put(const Reference&) { ++count; }
};

// Room for references, taken from any thread.
class ReferencePool {
public:
    explicit ReferencePool(Reference* begin) : begin_(begin) {}
    Reference* take(std::size_t count) { return begin_ + used_.fetch_add(count); }

private:
    Reference* begin_;
    std::atomic<std::size_t> used_{0};
};

// route(part, left, right) puts each reference of `part` to one side or both, be they Sides or Counts.
// Without a pool, `left` and `right` have room for the result. With one, room is taken as it is needed: the
// references are routed in chunks, and twice, first to count. If a side is empty then, nothing is written.
template <class Route>
void partition(std::span<const Reference> refs, const Route& route, ReferencePool* pool, Side& left,
               Side& right) {
    if (pool == nullptr) {
        route(refs, left, right);
        return;
    }
    struct Chunk {
        Count left_count, right_count;
        Side left, right;
    };
    std::vector<Chunk> chunks(chunk_count(refs.size()));
    for_each_chunk(refs.size(), [&](std::size_t c, std::size_t begin, std::size_t end) {
        Count left_count, right_count;
        route(refs.subspan(begin, end - begin), left_count, right_count);
        chunks[c].left_count = left_count;
        chunks[c].right_count = right_count;
    });
    for (const Chunk& chunk : chunks) {
        left.count += chunk.left_count.count;
        right.count += chunk.right_count.count;
    }
    if (left.count == 0 || right.count == 0) return;
    left.out = pool->take(std::size_t{left.count} + right.count);
    right.out = left.out + left.count;
    Reference *next_left = left.out, *next_right = right.out;
    for (Chunk& chunk : chunks) {
        chunk.left.out = std::exchange(next_left, next_left + chunk.left_count.count);
        chunk.right.out = std::exchange(next_right, next_right + chunk.right_count.count);
    }
    for_each_chunk(refs.size(), [&](std::size_t c, std::size_t begin, std::size_t end) {
        Side l = chunks[c].left, r = chunks[c].right;
        route(refs.subspan(begin, end - begin), l, r);
        chunks[c].left = l;
        chunks[c].right = r;
    });
    for (const Chunk& chunk : chunks) {
        left.extent.extend(chunk.left.extent);
        right.extent.extend(chunk.right.extent);
    }
}

}  // namespace ctpbench
