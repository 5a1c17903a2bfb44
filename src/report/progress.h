// The progress line: rewritten in place on a terminal, one plain line per step otherwise.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace ctpbench {

class Progress {
public:
    explicit Progress(bool quiet);
    ~Progress();

    // A run is a number of workloads of equal weight.
    void start_workload(std::size_t index, std::size_t count, const std::string& name);
    // What is going on now, at this share of the workload. May come from any thread.
    void step(const std::string& what, double share_of_workload);
    // A line that stays.
    void note(const std::string& text);

private:
    void show(const std::string& what, bool new_line);

    bool quiet_, terminal_;
    std::mutex mutex_;
    std::chrono::steady_clock::time_point start_, last_shown_;
    std::size_t workload_ = 0, workloads_ = 1;
    std::string name_, what_;
    double share_ = 0.0;
};

}  // namespace ctpbench
