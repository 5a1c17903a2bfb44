// The progress line: rewritten in place on a terminal, one plain line per step otherwise.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace ctpbench {

// What the time of a step grows with.
enum class Work {
    once,       // with the scene alone
    rays,       // with pixels and rays
    round,      // with these and the rounds; in a study of convergence, with the pictures' frames
    reference,  // with these and the frames of that study's reference
};

struct WorkSeconds {
    double once = 0.0, rays = 0.0, round = 0.0, reference = 0.0;

    double total() const { return once + rays + round + reference; }
    double& of(Work work) {
        return work == Work::once    ? once
               : work == Work::rays  ? rays
               : work == Work::round ? round
                                     : reference;
    }
};

class Progress {
public:
    explicit Progress(bool quiet);
    ~Progress();

    // A run is a number of workloads of equal weight.
    void start_workload(std::size_t index, std::size_t count, const std::string& name);
    // What is going on now, at this share of the workload. May come from any thread.
    void step(const std::string& what, double share_of_workload, Work work = Work::once);
    // What the workload has taken up to now.
    WorkSeconds work();
    // A line that stays.
    void note(const std::string& text);

private:
    void charge(std::chrono::steady_clock::time_point now);
    void show(const std::string& what, bool new_line);

    bool quiet_, terminal_;
    std::mutex mutex_;
    std::chrono::steady_clock::time_point start_, last_shown_;
    std::size_t workload_ = 0, workloads_ = 1;
    std::string name_, what_;
    double share_ = 0.0;
    Work doing_ = Work::once;
    std::chrono::steady_clock::time_point charged_;
    WorkSeconds taken_;
};

}  // namespace ctpbench
