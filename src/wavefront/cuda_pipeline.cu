#include "wavefront/cuda_pipeline.cuh"

#include <string_view>

#include "backends/cuda_blocks.cuh"
#include "kernels/blend.h"

namespace ctpbench {
namespace {

struct CopyIndex {
    const std::uint32_t* from;
    std::uint32_t* to;
    __device__ void operator()(std::uint32_t i) const { to[i] = from[i]; }
};

struct SetCount {
    std::uint32_t* count;
    std::uint32_t value;
    const std::uint32_t* copied;  // if not null, the value
    __device__ void operator()(std::uint32_t) const { *count = copied != nullptr ? *copied : value; }
};

// Three kernels; offsets and the entries moved stay on the device.
template <class By>
void reorder(cudaStream_t stream, std::uint32_t most, const TileInput<By>& in, const std::uint32_t* index,
             std::uint32_t* moved, std::uint32_t* offsets, const char* name) {
    launch_blocks(stream, tile_count(most), TileCount<By>{in}, name);
    launch_blocks(stream, 1, TileScan<By>{in, offsets}, name);
    launch_blocks(stream, tile_count(most), TileMove<By>{in, index, moved}, name);
}

}  // namespace

CudaPipeline::CudaPipeline(const DeviceIntersector& intersector, std::unique_ptr<DeviceShader> shader,
                           CudaLaunch launch, DeviceWavefront& wavefront, const SceneView& scene,
                           const Camera& camera, const FrameSettings& settings)
    : intersector_(intersector),
      shader_(std::move(shader)),
      launch_(launch),
      wavefront_(wavefront),
      camera_(camera_frame(camera.eye, camera.target, camera.up, camera.fov_degrees, settings.width,
                           settings.height)),
      settings_(settings),
      ambient_(scene.ambient()) {
    if (shader_->excludes() && !intersector_.excludes()) trap();  // every hit would be suspect
    if (shader_->excludes() && wavefront_.excluded.size() == 0)
        wavefront_.excluded = DeviceArray<std::uint32_t>(wavefront_.pixels);
    for (std::uint32_t k = 0; k < shader_->kernels(); ++k)
        if (const char* name = shader_->kernel_name(k)) part_names_[k] = std::string("shade_") + name;
}

CudaPipeline::~CudaPipeline() {
    if (graph_ != nullptr) cudaGraphExecDestroy(graph_);
}

std::vector<StageTime> CudaPipeline::frame(bool carry_t, std::uint32_t sample, ImageStorage& image,
                                           const BounceObserver& observe) {
    DeviceWavefront& w = wavefront_;
    image.resize(w.pixels);
    copy_columns(w.image.view(), image.view(), w.pixels);
    check_cuda(cudaDeviceSynchronize(), "waiting for the image");
    if (launch_ == CudaLaunch::graph && !observe)
        run_graph(carry_t, sample);
    else
        launch_frame(carry_t, sample, observe);
    stream_.wait();
    w.counts.download(w.host_counts.data(), w.host_counts.size());
    copy_columns(image.view(), w.image.view(), w.pixels);
    return stage_times();
}

void CudaPipeline::run_graph(bool carry_t, std::uint32_t sample) {
    // The sample's number is an argument of kernels, so each frame is captured and the graph updated with it.
    check_cuda(cudaStreamBeginCapture(stream_.get(), cudaStreamCaptureModeThreadLocal), "capturing a frame");
    launch_frame(carry_t, sample, {});
    cudaGraph_t captured = nullptr;
    check_cuda(cudaStreamEndCapture(stream_.get(), &captured), "capturing a frame");
    cudaGraphExecUpdateResultInfo result;
    if (graph_ == nullptr || cudaGraphExecUpdate(graph_, captured, &result) != cudaSuccess) {
        cudaGetLastError();
        if (graph_ != nullptr) check_cuda(cudaGraphExecDestroy(graph_), "replacing a graph");
        graph_ = nullptr;
        check_cuda(cudaGraphInstantiate(&graph_, captured, 0), "making a graph of a frame");
    }
    check_cuda(cudaGraphDestroy(captured), "making a graph of a frame");
    check_cuda(cudaGraphLaunch(graph_, stream_.get()), "launching a frame's graph");
}

void CudaPipeline::launch_frame(bool carry_t, std::uint32_t sample, const BounceObserver& observe) {
    DeviceWavefront& w = wavefront_;
    clock_.start(launch_ == CudaLaunch::graph && !observe);
    current_ = 0;
    check_cuda(cudaMemsetAsync(w.counts.data(), 0, w.counts.bytes(), stream_.get()), "clearing counts");
    launch_for_each(stream_.get(), {1}, SetCount{&counts(0)->active, w.pixels, nullptr}, "counting pixels");
    generate(sample);
    for (std::uint32_t bounce = 0; bounce <= settings_.bounces; ++bounce) {
        intersect(bounce, carry_t);
        if (observe) show(bounce, observe);
        if (settings_.copies) copy(bounce);
        if (sorts()) sort(bounce);
        shade(bounce, sample);
        if (shader_->order() != PathOrder::queued) compact(bounce);
    }
    clock_.time("blend", 0, stream_.get(), [&] {
        launch_for_each(stream_.get(), {w.pixels},
                        BlendKernel{w.paths.view(), w.image.view(), sample, w.fates.data()}, "blend");
    });
}

bool CudaPipeline::sorts() const {
    return shader_->order() == PathOrder::sorted || shader_->order() == PathOrder::restored;
}

void CudaPipeline::generate(std::uint32_t sample) {
    DeviceWavefront& w = wavefront_;
    clock_.time("generate", 0, stream_.get(), [&] {
        launch_for_each(stream_.get(), {w.pixels},
                        GenerateKernel{camera_, settings_.width, settings_.height, settings_.seed, sample,
                                       w.rays.view(), w.paths.view(), w.index[0].data(), excluded()},
                        "generate");
    });
}

void CudaPipeline::intersect(std::uint32_t bounce, bool carry_t) {
    DeviceWavefront& w = wavefront_;
    IntersectBuffers io{w.rays.view(), w.hits.view(), w.index[current_].data(), w.pixels, w.geometry.extent};
    io.keys.words = w.words;
    io.excluded = excluded();
    if (sorts()) io.keys.keys = w.keys.data();
    if (shader_->order() == PathOrder::queued)
        io.keys.queues = {w.queue_slots.data(), &counts(bounce)->queues, w.pixels};
    clock_.time("intersect", bounce, stream_.get(), [&] {
        intersector_.intersect(stream_.get(), io, {w.pixels, &counts(bounce)->active}, carry_t);
    });
}

void CudaPipeline::copy(std::uint32_t bounce) {
    DeviceWavefront& w = wavefront_;
    clock_.time("copy", bounce, stream_.get(), [&] {
        launch_for_each(stream_.get(), {w.pixels, &counts(bounce)->active},
                        CopyIndex{w.copied.data(), w.copied.data() + w.pixels}, "copy");
    });
}

void CudaPipeline::sort(std::uint32_t bounce) {
    DeviceWavefront& w = wavefront_;
    const bool restored = shader_->order() == PathOrder::restored;
    const std::uint32_t* from = restored ? w.identity.data() : w.index[current_].data();
    std::uint32_t* to = restored ? w.positions.data() : w.index[1 - current_].data();
    clock_.time("sort", bounce, stream_.get(), [&] {
        reorder<ByShadeKey>(stream_.get(), w.pixels,
                            {w.keys.data(), &counts(bounce)->active, w.tile_places.data()}, from, to,
                            counts(bounce)->sorted, "sort");
    });
    if (!restored) current_ = 1 - current_;
}

void CudaPipeline::shade(std::uint32_t bounce, std::uint32_t sample) {
    DeviceWavefront& w = wavefront_;
    const ShadeBuffers io{w.geometry,
                          w.attributes,
                          w.words,
                          w.rays.view(),
                          w.hits.view(),
                          w.paths.view(),
                          w.index[current_].data(),
                          w.fates.data(),
                          settings_.seed,
                          sample,
                          bounce,
                          ambient_,
                          settings_.roulette_from,
                          excluded()};
    const DeviceShadeWork work{w.pixels,
                               &counts(bounce)->active,
                               counts(bounce)->sorted,
                               shader_->order() == PathOrder::restored ? w.positions.data() : nullptr,
                               {w.queue_slots.data(), &counts(bounce)->queues, w.pixels},
                               w.index[1 - current_].data(),
                               &counts(bounce + 1)->active,
                               &counts(bounce)->dropped};
    const std::uint32_t n = shader_->kernels();
    clock_.time("shade", bounce, stream_.get(), [&] {
        if (n == 1 || launch_ == CudaLaunch::isolated) {
            for (std::uint32_t k = 0; k < n; ++k) shader_->launch(k, stream_.get(), io, work);
            return;
        }
        forked_.record(stream_.get());
        for (std::uint32_t k = 0; k < n; ++k) {
            const cudaStream_t own = streams_[k].get();
            check_cuda(cudaStreamWaitEvent(own, forked_.get()), "forking streams");
            clock_.time(part_names_[k].c_str(), bounce, own, [&] { shader_->launch(k, own, io, work); });
            joined_[k].record(own);
        }
        for (std::uint32_t k = 0; k < n; ++k)
            check_cuda(cudaStreamWaitEvent(stream_.get(), joined_[k].get()), "joining streams");
    });
    if (shader_->order() == PathOrder::queued) current_ = 1 - current_;
}

void CudaPipeline::compact(std::uint32_t bounce) {
    DeviceWavefront& w = wavefront_;
    // Sorted paths that hit nothing are at the end, and none of them goes on.
    const bool sorted = shader_->order() == PathOrder::sorted;
    const std::uint32_t* n = sorted ? counts(bounce)->sorted + kMissKey : &counts(bounce)->active;
    clock_.time("compact", bounce, stream_.get(), [&] {
        reorder<ByFate>(stream_.get(), w.pixels, {w.fates.data(), n, w.tile_places.data()},
                        w.index[current_].data(), w.index[1 - current_].data(), counts(bounce)->compacted,
                        "compact");
        launch_for_each(stream_.get(), {1},
                        SetCount{&counts(bounce + 1)->active, 0, counts(bounce)->compacted + 1}, "compact");
    });
    current_ = 1 - current_;
}

void CudaPipeline::show(std::uint32_t bounce, const BounceObserver& observe) {
    DeviceWavefront& w = wavefront_;
    stream_.wait();
    w.counts.download(w.host_counts.data(), w.host_counts.size());
    const std::uint32_t active = w.host_counts[bounce].active;
    if (active == 0) return;
    std::vector<std::uint32_t> slots(active);
    w.index[current_].download(slots.data(), active);
    RayStorage rays;
    HitStorage hits;
    rays.resize(w.pixels), hits.resize(w.pixels);
    copy_columns(rays.view(), w.rays.view(), w.pixels);
    copy_columns(hits.view(), w.hits.view(), w.pixels);
    std::vector<std::uint32_t> excluded_ids(excluded() != nullptr ? w.pixels : 0);
    if (excluded() != nullptr) w.excluded.download(excluded_ids.data(), w.pixels);
    observe({bounce, rays.view(), hits.view(), slots, excluded() != nullptr ? excluded_ids.data() : nullptr});
}

std::vector<StageTime> CudaPipeline::stage_times() const {
    const DeviceWavefront& w = wavefront_;
    std::vector<std::uint8_t> clamped(w.pixels);
    w.fates.download(clamped.data(), w.pixels);
    std::vector<StageTime> times;
    for (const FrameClock::Span& s : clock_.spans()) {
        const std::string_view kernel = s.kernel;
        const BounceCounts& counted = w.host_counts[s.bounce];
        StageTime stage{s.kernel, s.bounce, counted.active, clock_.seconds(s)};
        stage.start = clock_.start_of(s);
        if (kernel == "generate" || kernel == "blend") stage.rays = w.pixels;
        if (kernel == "shade")
            stage.dropped = shader_->order() == PathOrder::queued
                                ? counted.dropped
                                : counted.compacted[2] - counted.compacted[1];
        if (kernel == "blend")
            for (const std::uint8_t c : clamped) stage.clamped += c;
        for (std::uint32_t k = 0; k < kShadeKeys; ++k)
            if (kernel == part_names_[k])
                stage.rays = shader_->order() == PathOrder::queued
                                 ? counted.queues.of[k]
                                 : counted.sorted[k + 1] - counted.sorted[k];
        if (stage.rays > 0) times.push_back(stage);  // a bounce that nobody reached is none
    }
    return times;
}

}  // namespace ctpbench
