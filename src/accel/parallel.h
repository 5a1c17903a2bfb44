// Parallel loops whose result does not depend on the number of threads: the work is cut into chunks of a
// fixed size, and partial results are joined in order.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <memory>

namespace ctpbench {

inline constexpr std::size_t kChunk = 16384;

inline std::size_t chunk_count(std::size_t n) { return (n + kChunk - 1) / kChunk; }

// body(chunk, begin, end) for every chunk of 0..n-1.
template <class Body>
void for_each_chunk(std::size_t n, const Body& body) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, chunk_count(n), 1), [&](const auto& range) {
        for (std::size_t c = range.begin(); c < range.end(); ++c) {
            body(c, c * kChunk, std::min(n, (c + 1) * kChunk));
        }
    });
}

// body(begin, end, partial) sets what its part gives; join(into, from) in the order of the chunks.
template <class T, class Body, class Join>
T reduce_in_chunks(std::size_t n, const Body& body, const Join& join) {
    T result;
    if (n <= kChunk) {
        body(std::size_t{0}, n, result);
        return result;
    }
    const auto partial = std::make_unique_for_overwrite<T[]>(chunk_count(n) - 1);
    for_each_chunk(n, [&](std::size_t c, std::size_t begin, std::size_t end) {
        body(begin, end, c == 0 ? result : partial[c - 1]);
    });
    for (std::size_t c = 1; c < chunk_count(n); ++c) join(result, partial[c - 1]);
    return result;
}

}  // namespace ctpbench
