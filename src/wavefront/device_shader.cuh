// One contender of the shade stage on a device, with its materials laid out there.
#pragma once

#include <memory>
#include <string_view>

#include "kernels/dispatch/shade/layout.h"
#include "wavefront/device_place.cuh"

namespace ctpbench {

// The paths of one bounce. All counts are the device's; no list is longer than `most`.
struct DeviceShadeWork {
    std::uint32_t most;
    const std::uint32_t* count;        // as_traced: paths in the index
    const std::uint32_t* key_offsets;  // sorted, restored: where each key's paths begin, and their number
    const std::uint32_t* positions;    // restored: positions in the index, sorted by key; else null
    PathQueues queues;                 // queued
    std::uint32_t* survivors;          // queued: slots of the paths that go on, in any order
    std::uint32_t* survivor_count;     // queued; 0 before the stage
    std::uint32_t* dropped;            // queued: samples of value 0; 0 before the stage
};

class DeviceShader {
public:
    virtual ~DeviceShader() = default;
    virtual PathOrder order() const = 0;
    // Whether it writes ShadeBuffers::excluded, which the intersector must then heed.
    virtual bool excludes() const = 0;
    // How many kernels a bounce takes, and what the paths of each have in common; null if one takes all.
    virtual std::uint32_t kernels() const = 0;
    virtual const char* kernel_name(std::uint32_t kernel) const = 0;
    virtual void launch(std::uint32_t kernel, cudaStream_t stream, const ShadeBuffers& io,
                        const DeviceShadeWork& work) const = 0;
};

// As make_shader(). The place must outlive it.
std::unique_ptr<DeviceShader> make_device_shader(const DevicePlace& place, std::string_view strategy,
                                                 const MaterialInput& materials, std::string_view offset);

}  // namespace ctpbench
