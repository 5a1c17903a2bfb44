#include "backends/cpu.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

namespace ctpbench {

void CpuBackend::for_each_chunk(std::uint32_t count, std::uint32_t grain, Chunk chunk, const void* kernel) {
    using Range = oneapi::tbb::blocked_range<std::uint32_t>;
    arena_.execute([&] {
        oneapi::tbb::parallel_for(
            Range(0, count, grain), [=](const Range& range) { chunk(kernel, range.begin(), range.end()); },
            oneapi::tbb::simple_partitioner{});
    });
}

}  // namespace ctpbench
