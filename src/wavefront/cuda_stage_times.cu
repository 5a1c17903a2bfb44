#include "wavefront/cuda_stage_times.cuh"

#include <string_view>

#include "wavefront/device_copy.cuh"

namespace ctpbench {

std::vector<StageTime> stage_times(const FrameClock& clock, const PlacedWavefront& wavefront, PathOrder order,
                                   const ShadePartNames& parts) {
    const bool queued = order == PathOrder::queued;
    std::vector<std::uint8_t> clamped(wavefront.pixels);
    copy_column(clamped.data(), wavefront.fates, wavefront.pixels);
    std::vector<StageTime> times;
    for (const FrameClock::Span& s : clock.spans()) {
        const std::string_view kernel = s.kernel;
        const BounceCounts& counted = wavefront.host_counts[s.bounce];
        StageTime stage{s.kernel, s.bounce, counted.active, clock.seconds(s)};
        stage.start = clock.start_of(s);
        if (kernel == "generate" || kernel == "blend") stage.rays = wavefront.pixels;
        if (kernel == "shade")
            stage.dropped = queued ? counted.dropped : counted.compacted[2] - counted.compacted[1];
        if (kernel == "blend")
            for (const std::uint8_t c : clamped) stage.clamped += c;
        for (std::uint32_t k = 0; k < parts.size(); ++k)
            if (kernel == parts[k])
                stage.rays = queued ? counted.queues[k] : counted.sorted[k + 1] - counted.sorted[k];
        if (stage.rays > 0) times.push_back(stage);
    }
    return times;
}

}  // namespace ctpbench
