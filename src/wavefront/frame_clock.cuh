// When the stages of a frame began and ended on the device. Events are made once and used again each frame.
#pragma once

#include <deque>
#include <vector>

#include "backends/device_event.cuh"
#include "wavefront/frame.h"

namespace ctpbench {

class FrameClock {
public:
    struct Span {
        const char* kernel;
        std::uint32_t bounce;
        std::size_t begin, end;  // events
    };

    // `captured`: what follows is captured into a graph.
    void start(bool captured) { captured_ = captured, used_ = 0, spans_.clear(); }

    // Runs f(), which launches into the stream, between two events.
    template <class F>
    void time(const char* kernel, std::uint32_t bounce, cudaStream_t stream, F&& f) {
        const std::size_t begin = record(stream);
        f();
        const std::size_t end = record(stream);
        spans_.push_back({kernel, bounce, begin, end});
    }

    const std::vector<Span>& spans() const { return spans_; }
    // After the frame has ended.
    double seconds(const Span& s) const { return seconds_between(events_[s.begin], events_[s.end]); }
    double start_of(const Span& s) const {
        return seconds_between(events_[spans_.front().begin], events_[s.begin]);
    }

private:
    std::size_t record(cudaStream_t stream) {
        if (used_ == events_.size()) events_.emplace_back();
        events_[used_].record(stream, captured_);
        return used_++;
    }

    bool captured_ = false;
    std::deque<DeviceEvent> events_;
    std::size_t used_ = 0;
    std::vector<Span> spans_;
};

}  // namespace ctpbench
