// Events and streams with one owner. Times are those of the device: between two events of one stream, all
// that was launched in between.
#pragma once

#include <utility>

#include "backends/cuda_check.cuh"

namespace ctpbench {

class DeviceEvent {
public:
    DeviceEvent() { check_cuda(cudaEventCreate(&event_), "creating an event"); }
    DeviceEvent(DeviceEvent&& o) noexcept : event_(std::exchange(o.event_, nullptr)) {}
    DeviceEvent& operator=(DeviceEvent&&) = delete;
    ~DeviceEvent() {
        if (event_ != nullptr) cudaEventDestroy(event_);
    }

    cudaEvent_t get() const { return event_; }
    // `captured`: into a graph, as a node that records when the graph runs.
    void record(cudaStream_t stream, bool captured = false) const {
        check_cuda(cudaEventRecordWithFlags(event_, stream,
                                            captured ? cudaEventRecordExternal : cudaEventRecordDefault),
                   "recording an event");
    }
    void wait() const { check_cuda(cudaEventSynchronize(event_), "waiting for kernels"); }

private:
    cudaEvent_t event_ = nullptr;
};

// Both must have been reached.
inline double seconds_between(const DeviceEvent& from, const DeviceEvent& to) {
    float ms = 0.0f;
    check_cuda(cudaEventElapsedTime(&ms, from.get(), to.get()), "reading event times");
    return ms * 1e-3;
}

class DeviceStream {
public:
    DeviceStream() {
        check_cuda(cudaStreamCreateWithFlags(&stream_, cudaStreamNonBlocking), "creating a stream");
    }
    DeviceStream(DeviceStream&& o) noexcept : stream_(std::exchange(o.stream_, nullptr)) {}
    DeviceStream& operator=(DeviceStream&&) = delete;
    ~DeviceStream() {
        if (stream_ != nullptr) cudaStreamDestroy(stream_);
    }
    cudaStream_t get() const { return stream_; }
    void wait() const { check_cuda(cudaStreamSynchronize(stream_), "waiting for a stream"); }

private:
    cudaStream_t stream_ = nullptr;
};

}  // namespace ctpbench
