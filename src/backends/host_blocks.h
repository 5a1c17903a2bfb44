// Runs block programs (kernels/tile.h) on the host, thread by thread within each phase.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace ctpbench {

namespace detail {
template <std::uint32_t phase, class Program>
void run_host_phases(const Program& program, std::uint32_t block, typename Program::Shared& shared,
                     std::vector<typename Program::Thread>& threads) {
    if constexpr (phase < Program::phases) {
        for (std::uint32_t t = 0; t < Program::threads; ++t)
            program.template run<phase>(block, t, shared, threads[t]);
        run_host_phases<phase + 1>(program, block, shared, threads);
    }
}
}  // namespace detail

template <class Program>
void run_blocks_on_host(std::uint32_t blocks, const Program& program) {
    for (std::uint32_t b = 0; b < blocks; ++b) {
        if (program.idle(b)) continue;
        const auto shared = std::make_unique<typename Program::Shared>();
        std::vector<typename Program::Thread> threads(Program::threads);
        detail::run_host_phases<0>(program, b, *shared, threads);
    }
}

}  // namespace ctpbench
