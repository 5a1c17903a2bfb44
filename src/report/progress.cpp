#include "report/progress.h"

#include <unistd.h>

#include <cstdio>

#include "report/duration.h"

namespace ctpbench {
namespace {

constexpr auto kRefresh = std::chrono::milliseconds(250);

}  // namespace

Progress::Progress(bool quiet)
    : quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()),
      charged_(start_) {}

Progress::~Progress() {
    if (terminal_ && !quiet_) std::fputs("\r\033[K", stderr);
}

void Progress::start_workload(std::size_t index, std::size_t count, const std::string& name) {
    const std::lock_guard lock(mutex_);
    workload_ = index, workloads_ = count, name_ = name, share_ = 0.0;
    doing_ = Work::once, charged_ = std::chrono::steady_clock::now(), taken_ = {};
}

void Progress::charge(std::chrono::steady_clock::time_point now) {
    taken_.of(doing_) += std::chrono::duration<double>(now - charged_).count();
    charged_ = now;
}

WorkSeconds Progress::work() {
    const std::lock_guard lock(mutex_);
    charge(std::chrono::steady_clock::now());
    return taken_;
}

void Progress::step(const std::string& what, double share_of_workload, Work work) {
    const std::lock_guard lock(mutex_);
    share_ = share_of_workload;
    const auto now = std::chrono::steady_clock::now();
    charge(now);
    doing_ = work;
    const bool changed = what != what_;
    what_ = what;
    if (quiet_ || (!changed && (!terminal_ || now - last_shown_ < kRefresh))) return;
    last_shown_ = now;
    show(what, !terminal_);
}

void Progress::show(const std::string& what, bool new_line) {
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const double done = (static_cast<double>(workload_) + share_) / static_cast<double>(workloads_);
    std::string line = "[" + std::to_string(workload_ + 1) + "/" + std::to_string(workloads_) + "] " + name_ +
                       ": " + what + "  " + std::to_string(static_cast<int>(100.0 * done)) + " %, " +
                       duration(elapsed);
    if (done > 0.02) line += ", about " + duration(elapsed / done - elapsed) + " left";
    std::fprintf(stderr, new_line ? "%s\n" : "\r\033[K%s", line.c_str());
    std::fflush(stderr);
}

void Progress::note(const std::string& text) {
    const std::lock_guard lock(mutex_);
    std::fprintf(stderr, terminal_ && !quiet_ ? "\r\033[K%s\n" : "%s\n", text.c_str());
}

}  // namespace ctpbench
