// Reports a build's progress from a thread of its own, so that neither a large node's long loops nor a
// busy pool delay it.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

#include "accel/sbvh.h"

namespace ctpbench {

class ProgressReporter {
public:
    ProgressReporter(const BuildProgress& callback, std::uint64_t total)
        : callback_(callback), total_(total) {
        if (!callback_) return;
        callback_(0.0);
        thread_ = std::jthread([this](std::stop_token stop) {
            std::unique_lock lock(mutex_);
            while (!wake_.wait_for(lock, stop, std::chrono::milliseconds(200),
                                   [&] { return stop.stop_requested(); })) {
                callback_(static_cast<double>(done_.load()) / static_cast<double>(total_));
            }
        });
    }
    // From any thread.
    void add(std::uint64_t amount) { done_.fetch_add(amount, std::memory_order_relaxed); }

    void finish() {
        if (!callback_) return;
        thread_.request_stop();
        thread_.join();
        callback_(1.0);
    }

private:
    const BuildProgress& callback_;
    const std::uint64_t total_;
    std::atomic<std::uint64_t> done_{0};
    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::jthread thread_;  // last: stops before what it uses goes
};

}  // namespace ctpbench
