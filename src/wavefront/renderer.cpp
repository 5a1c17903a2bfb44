#include "wavefront/renderer.h"

#include <algorithm>
#include <cstring>
#include <numeric>

#include "base/clock.h"
#include "kernels/blend.h"
#include "kernels/reorder.h"

namespace ctpbench {

Renderer::Renderer(CpuBackend& backend, const SceneView& scene, const Camera& camera,
                   const FrameSettings& settings)
    : backend_(backend),
      scene_(scene),
      camera_(camera_frame(camera.eye, camera.target, camera.up, camera.fov_degrees, settings.width,
                           settings.height)),
      settings_(settings),
      segments_((settings.width * settings.height + kSegment - 1) / kSegment) {
    const std::uint32_t n = pixels();
    rays_.resize(n), hits_.resize(n), pixels_.resize(n);
    index_.resize(std::size_t{segments_} * kSegment + 64), reordered_.resize(index_.size());
    keys_.resize(n), fates_.resize(n);
    if (settings.copies) copied_.resize(2 * std::size_t{n});
}

std::vector<StageTime> Renderer::frame(const Intersector& intersector, const Shader& shader, bool carry_t,
                                       std::uint32_t sample, ImageStorage& image,
                                       const BounceObserver& observe) {
    const PathOrder order = shader.order();
    times_.clear();
    words_ = shader.words();
    if (order == PathOrder::queued) {
        // Never smaller than a contender before needed them: renderers are shared.
        const std::size_t slots = std::size_t{words_.keys()} * segments_ * kSegment;
        if (queue_slots_.size() < slots) queue_slots_.resize(slots);
        queue_counts_.resize(std::size_t{segments_} * segment_stride(words_.keys()));
        segment_counts_.resize(segments_), dropped_counts_.resize(segments_);
    }
    if (shader.excludes() && !intersector.excludes()) trap();  // every hit would be suspect
    if (shader.excludes()) excluded_.resize(pixels());
    exclude_ = shader.excludes() ? excluded_.data() : nullptr;
    generate(sample);
    for (std::uint32_t bounce = 0; bounce <= settings_.bounces && active_ > 0; ++bounce) {
        intersect(bounce, intersector, order, carry_t);
        if (observe) show(bounce, order, observe);
        if (settings_.copies) copy(bounce);
        if (order == PathOrder::sorted || order == PathOrder::restored) sort(bounce, order);
        shade(bounce, sample, shader);
        if (order != PathOrder::queued) compact(bounce, order);
    }
    blend(sample, image);
    return times_;
}

template <class F>
StageTime& Renderer::time(const char* kernel, std::uint32_t bounce, F&& stage) {
    const std::uint32_t rays = active_;
    const double seconds = seconds_of(stage);
    return times_.emplace_back(StageTime{kernel, bounce, rays, seconds});
}

void Renderer::generate(std::uint32_t sample) {
    active_ = pixels();
    time("generate", 0, [&] {
        backend_.for_each(active_,
                          GenerateKernel{camera_, settings_.width, settings_.height, settings_.seed, sample,
                                         rays_.view(), pixels_.view(), index_.data(), exclude_});
    });
    // The index is full, so its segments are, but for the last.
    for (std::uint32_t s = 0; s < segment_counts_.size(); ++s)
        segment_counts_[s] = std::min(kSegment, active_ - s * kSegment);
}

void Renderer::intersect(std::uint32_t bounce, const Intersector& intersector, PathOrder order,
                         bool carry_t) {
    IntersectBuffers io{rays_.view(), hits_.view(), index_.data(), active_, scene_.geometry().extent};
    io.keys.words = words_;
    io.excluded = exclude_;
    if (order == PathOrder::sorted || order == PathOrder::restored) io.keys.keys = keys_.data();
    time("intersect", bounce, [&] {
        if (order == PathOrder::queued) {
            std::fill(queue_counts_.begin(), queue_counts_.end(), 0u);
            io.keys.queues = queues();
            io.segment_counts = segment_counts_.data(), io.segments = segments_;
        }
        intersector.intersect(backend_, io, carry_t);
    });
}

PathQueues Renderer::queues() {
    return {queue_slots_.data(), queue_counts_.data(), segments_ * kSegment, segment_stride(words_.keys())};
}

void Renderer::copy(std::uint32_t bounce) {
    struct Kernel {
        const std::uint32_t* from;
        std::uint32_t count;
        std::uint32_t* to;
        void operator()(std::uint32_t block) const {
            const BlockRange range = block_range(block, count);
            std::memcpy(to + range.begin, from + range.begin,
                        (range.end - range.begin) * sizeof(std::uint32_t));
        }
    };
    time("copy", bounce, [&] {
        backend_.for_each(block_count(active_), Kernel{copied_.data(), active_, copied_.data() + pixels()},
                          1);
    });
}

void Renderer::sort(std::uint32_t bounce, PathOrder order) {
    const bool restored = order == PathOrder::restored;
    if (restored && positions_.empty()) {
        positions_.resize(pixels());
        std::iota(positions_.begin(), positions_.end(), 0u);
    }
    time("sort", bounce, [&] {
        sorting_.run(backend_, keys_.data(), words_.keys(), restored ? positions_.data() : index_.data(),
                     active_, reordered_.data(), work_.key_offsets);
    });
    work_.positions = reordered_.data();
    if (!restored) index_.swap(reordered_);
}

void Renderer::shade(std::uint32_t bounce, std::uint32_t sample, const Shader& shader) {
    const ShadeBuffers io{scene_.geometry(),
                          scene_.attributes(),
                          words_,
                          rays_.view(),
                          hits_.view(),
                          pixels_.view(),
                          index_.data(),
                          fates_.data(),
                          settings_.seed,
                          sample,
                          bounce,
                          scene_.ambient(),
                          settings_.roulette_from,
                          exclude_};
    work_.count = active_;
    if (shader.order() == PathOrder::queued) {
        work_.queues = queues();
        work_.survivors = index_.data(), work_.survivor_counts = segment_counts_.data();
        work_.dropped_counts = dropped_counts_.data(), work_.segments = segments_;
    }
    StageTime& shaded = time("shade", bounce, [&] { shader.shade(backend_, io, work_); });
    if (shader.order() == PathOrder::queued) {
        active_ = std::accumulate(segment_counts_.begin(), segment_counts_.end(), 0u);
        shaded.dropped = std::accumulate(dropped_counts_.begin(), dropped_counts_.end(), 0u);
    } else {
        shaded.dropped = static_cast<std::uint32_t>(std::count(fates_.begin(), fates_.begin() + active_,
                                                               static_cast<std::uint8_t>(PathFate::dropped)));
    }
}

void Renderer::compact(std::uint32_t bounce, PathOrder order) {
    // Sorted paths that hit nothing are at the end, and none of them goes on.
    const std::uint32_t n = order == PathOrder::sorted ? work_.key_offsets[words_.miss_key()] : active_;
    std::uint32_t kept = 0;
    time("compact", bounce,
         [&] { kept = compaction_.run(backend_, fates_.data(), index_.data(), n, reordered_.data()); });
    index_.swap(reordered_);
    active_ = kept;
}

void Renderer::blend(std::uint32_t sample, ImageStorage& image) {
    image.resize(pixels());
    active_ = pixels();
    Array<std::uint8_t>& clamped = fates_;  // no longer of use to anyone
    StageTime& blended = time("blend", 0, [&] {
        backend_.for_each(active_, BlendKernel{pixels_.view(), image.view(), sample, clamped.data()});
    });
    blended.clamped = std::accumulate(clamped.begin(), clamped.end(), 0u);
}

void Renderer::show(std::uint32_t bounce, PathOrder order, const BounceObserver& observe) {
    std::vector<std::uint32_t> slots;
    slots.reserve(active_);
    if (order == PathOrder::queued) {
        for (std::uint32_t s = 0; s < segments_; ++s) {
            const auto begin = index_.begin() + s * kSegment;
            slots.insert(slots.end(), begin, begin + segment_counts_[s]);
        }
    } else {
        slots.assign(index_.begin(), index_.begin() + active_);
    }
    observe({bounce, rays_.view(), hits_.view(), slots, exclude_});
}

}  // namespace ctpbench
