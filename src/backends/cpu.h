// The CPU backend: a kernel's functor over an index range on a fixed number of threads.
#pragma once

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <cstdint>
#include <utility>

namespace ctpbench {

class CpuBackend {
public:
    // 0 threads: as many as the machine allows this process.
    explicit CpuBackend(int threads = 0)
        : arena_(threads > 0 ? threads : static_cast<int>(oneapi::tbb::task_arena::automatic)) {
        arena_.initialize();
    }

    int threads() const { return arena_.max_concurrency(); }

    // Calls kernel(i) for i in [0, count), in chunks of `grain`.
    template <class Kernel>
    void for_each(std::uint32_t count, const Kernel& kernel, std::uint32_t grain = 1024) {
        arena_.execute([&] {
            oneapi::tbb::parallel_for(
                oneapi::tbb::blocked_range<std::uint32_t>(0, count, grain),
                [kernel](const oneapi::tbb::blocked_range<std::uint32_t>& range) {
                    const Kernel local = kernel;  // on this thread's stack: no store aliases it
                    for (std::uint32_t i = range.begin(); i != range.end(); ++i) local(i);
                },
                oneapi::tbb::simple_partitioner{});
        });
    }

    // Calls kernel(s size + i) for each segment s and i in [0, counts[s]); a segment goes to one thread, in
    // order.
    template <class Kernel>
    void for_each_in_segments(std::uint32_t segments, std::uint32_t size, const std::uint32_t* counts,
                              const Kernel& kernel) {
        for_each(
            segments,
            [=](std::uint32_t segment) {
                const std::uint32_t begin = segment * size, end = begin + counts[segment];
                for (std::uint32_t i = begin; i < end; ++i) kernel(i);
            },
            1);
    }

    // Runs f inside the arena, for work that oneTBB spreads by itself (the tree builder).
    template <class F>
    decltype(auto) execute(F&& f) {
        return arena_.execute(std::forward<F>(f));
    }

private:
    oneapi::tbb::task_arena arena_;
};

}  // namespace ctpbench
