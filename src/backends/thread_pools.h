// CPU backends by their number of threads.
#pragma once

#include <map>

#include "backends/cpu.h"

namespace ctpbench {

class ThreadPools {
public:
    // `own` must outlive it.
    explicit ThreadPools(CpuBackend& own) : own_(own) {}

    // That of so many threads, made when first asked for; 0: the one given. Asking for more than allowed()
    // does not make more: threads beyond that would not run.
    CpuBackend& get(int threads) {
        return threads == 0 ? own_ : pools_.try_emplace(threads, threads).first->second;
    }

    // How many threads the machine allows this process.
    static int allowed() { return CpuBackend().threads(); }

private:
    CpuBackend& own_;
    std::map<int, CpuBackend> pools_;
};

}  // namespace ctpbench
