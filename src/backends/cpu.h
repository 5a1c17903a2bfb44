// The CPU backend: a kernel's functor over an index range on a fixed number of threads.
#pragma once

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

    // Calls kernel(i) for i in [0, count), in chunks of `grain`. A kernel whose call is not inlined there
    // reads its members anew after every store.
    template <class Kernel>
    void for_each(std::uint32_t count, const Kernel& kernel, std::uint32_t grain = 1024) {
        const auto chunk = [](const void* shared, std::uint32_t begin, std::uint32_t end) {
            const Kernel local =
                *static_cast<const Kernel*>(shared);  // on this thread's stack: no store aliases it
            for (std::uint32_t i = begin; i != end; ++i) local(i);
        };
        for_each_chunk(count, grain, chunk, &kernel);
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

    // Calls chunk(shared, begin, end) for chunks of at most `grain` of [0, count). A chunk is worth a call
    // through a pointer; one instantiation of oneTBB's loop then serves all kernels.
    using Chunk = void (*)(const void* shared, std::uint32_t begin, std::uint32_t end);
    void for_each_chunk(std::uint32_t count, std::uint32_t grain, Chunk chunk, const void* shared);

private:
    oneapi::tbb::task_arena arena_;
};

}  // namespace ctpbench
