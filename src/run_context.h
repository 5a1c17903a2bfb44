// What the parts of a run share: where results go, and how to say what is going on.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>

#include "backends/thread_pools.h"
#include "base/interrupt.h"
#include "config/config.h"
#include "measure/results.h"
#include "report/progress.h"
#include "report/rows.h"

namespace ctpbench {

// Thrown at the next safe point after Ctrl-C.
struct Interrupted {};

inline void stop_if_interrupted() {
    if (interrupted()) throw Interrupted{};
}

struct RunContext {
    const Config& config;
    const std::filesystem::path& folder;
    CpuBackend& backend;
    ThreadPools& pools;  // for contenders that ask for a number of threads
    Progress& progress;
    RowsFile& rows;
    Results& results;
    bool quiet;
    std::string isa;  // of kernels over packs

    // A line for the user that is kept with the results; each once.
    void note(const std::string& text) const {
        auto& notices = results.notices;
        if (std::find(notices.begin(), notices.end(), text) != notices.end()) return;
        notices.push_back(text);
        if (!quiet) progress.note(text);
    }
};

}  // namespace ctpbench
