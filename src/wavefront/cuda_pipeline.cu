#include "wavefront/cuda_pipeline.cuh"

#include "kernels/blend.h"
#include "wavefront/device_copy.cuh"
#include "wavefront/device_reorder.cuh"

namespace ctpbench {

CudaPipeline::CudaPipeline(const DeviceIntersector& intersector, std::unique_ptr<DeviceShader> shader,
                           const MaterialWords& words, CudaLaunch launch, PlacedWavefront& wavefront,
                           const SceneView& scene, const Camera& camera, const FrameSettings& settings)
    : intersector_(intersector),
      shader_(std::move(shader)),
      words_(words),
      launch_(launch),
      wavefront_(wavefront),
      camera_(camera_frame(camera.eye, camera.target, camera.up, camera.fov_degrees, settings.width,
                           settings.height)),
      settings_(settings),
      ambient_(scene.ambient()),
      streams_(shader_->kernels()),
      joined_(shader_->kernels()),
      part_names_(shader_->kernels()) {
    if (shader_->excludes() && !intersector_.excludes()) trap();  // every hit would be suspect
    for (std::uint32_t k = 0; k < shader_->kernels(); ++k)
        if (const char* name = shader_->kernel_name(k)) part_names_[k] = std::string("shade_") + name;
}

std::vector<StageTime> CudaPipeline::frame(bool carry_t, std::uint32_t sample, ImageStorage& image,
                                           const BounceObserver& observe) {
    PlacedWavefront& w = wavefront_;
    image.resize(w.pixels);
    copy_columns(w.image, image.view(), w.pixels);
    check_cuda(cudaDeviceSynchronize(), "waiting for the image");
    if (launch_ == CudaLaunch::graph && !observe)
        graph_.run(stream_.get(), [&] { launch_frame(carry_t, sample, {}); });
    else
        launch_frame(carry_t, sample, observe);
    stream_.wait();
    copy_column(w.host_counts.data(), w.counts, w.host_counts.size());
    copy_columns(image.view(), w.image, w.pixels);
    return stage_times(clock_, w, shader_->order(), part_names_);
}

void CudaPipeline::launch_frame(bool carry_t, std::uint32_t sample, const BounceObserver& observe) {
    PlacedWavefront& w = wavefront_;
    clock_.start(launch_ == CudaLaunch::graph && !observe);
    current_ = 0;
    check_cuda(cudaMemsetAsync(w.counts, 0, w.host_counts.size() * sizeof(BounceCounts), stream_.get()),
               "clearing counts");
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
        launch_for_each(stream_.get(), {w.pixels}, BlendKernel{w.paths, w.image, sample, w.fates}, "blend");
    });
}

bool CudaPipeline::sorts() const {
    return shader_->order() == PathOrder::sorted || shader_->order() == PathOrder::restored;
}

void CudaPipeline::generate(std::uint32_t sample) {
    PlacedWavefront& w = wavefront_;
    clock_.time("generate", 0, stream_.get(), [&] {
        launch_for_each(stream_.get(), {w.pixels},
                        GenerateKernel{camera_, settings_.width, settings_.height, settings_.seed, sample,
                                       w.rays, w.paths, w.index[0], excluded()},
                        "generate");
    });
}

void CudaPipeline::intersect(std::uint32_t bounce, bool carry_t) {
    PlacedWavefront& w = wavefront_;
    IntersectBuffers io{w.rays, w.hits, w.index[current_], w.pixels, w.geometry.extent};
    io.keys.words = words_;
    io.excluded = excluded();
    if (sorts()) io.keys.keys = w.keys;
    if (shader_->order() == PathOrder::queued)
        io.keys.queues = {w.queue_slots, counts(bounce)->queues, w.pixels};
    clock_.time("intersect", bounce, stream_.get(), [&] {
        intersector_.intersect(stream_.get(), io, {w.pixels, &counts(bounce)->active}, carry_t);
    });
}

void CudaPipeline::copy(std::uint32_t bounce) {
    PlacedWavefront& w = wavefront_;
    clock_.time("copy", bounce, stream_.get(), [&] {
        launch_for_each(stream_.get(), {w.pixels, &counts(bounce)->active},
                        CopyIndex{w.copied, w.copied + w.pixels}, "copy");
    });
}

void CudaPipeline::sort(std::uint32_t bounce) {
    PlacedWavefront& w = wavefront_;
    const bool restored = shader_->order() == PathOrder::restored;
    const std::uint32_t* from = restored ? w.identity : w.index[current_];
    std::uint32_t* to = restored ? w.positions : w.index[1 - current_];
    clock_.time("sort", bounce, stream_.get(), [&] {
        sort_by_shade_key(stream_.get(), w.pixels,
                          {w.keys, &counts(bounce)->active, w.tile_places, words_.keys()}, from, to,
                          counts(bounce)->sorted);
    });
    if (!restored) current_ = 1 - current_;
}

void CudaPipeline::shade(std::uint32_t bounce, std::uint32_t sample) {
    PlacedWavefront& w = wavefront_;
    const ShadeBuffers io{w.geometry,
                          w.attributes,
                          words_,
                          w.rays,
                          w.hits,
                          w.paths,
                          w.index[current_],
                          w.fates,
                          settings_.seed,
                          sample,
                          bounce,
                          ambient_,
                          settings_.roulette_from,
                          excluded()};
    const DeviceShadeWork work{w.pixels,
                               &counts(bounce)->active,
                               counts(bounce)->sorted,
                               shader_->order() == PathOrder::restored ? w.positions : nullptr,
                               {w.queue_slots, counts(bounce)->queues, w.pixels},
                               w.index[1 - current_],
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
    PlacedWavefront& w = wavefront_;
    // Sorted paths that hit nothing are at the end, and none of them goes on.
    const bool sorted = shader_->order() == PathOrder::sorted;
    const std::uint32_t* n = sorted ? counts(bounce)->sorted + words_.miss_key() : &counts(bounce)->active;
    clock_.time("compact", bounce, stream_.get(), [&] {
        reorder<ByFate>(stream_.get(), w.pixels, {w.fates, n, w.tile_places}, w.index[current_],
                        w.index[1 - current_], counts(bounce)->compacted, "compact");
        launch_for_each(stream_.get(), {1},
                        SetCount{&counts(bounce + 1)->active, 0, counts(bounce)->compacted + 1}, "compact");
    });
    current_ = 1 - current_;
}

void CudaPipeline::show(std::uint32_t bounce, const BounceObserver& observe) {
    PlacedWavefront& w = wavefront_;
    stream_.wait();
    copy_column(w.host_counts.data(), w.counts, w.host_counts.size());
    const std::uint32_t active = w.host_counts[bounce].active;
    if (active == 0) return;
    std::vector<std::uint32_t> slots(active);
    copy_column(slots.data(), w.index[current_], active);
    RayStorage rays;
    HitStorage hits;
    rays.resize(w.pixels), hits.resize(w.pixels);
    copy_columns(rays.view(), w.rays, w.pixels);
    copy_columns(hits.view(), w.hits, w.pixels);
    std::vector<std::uint32_t> left_out(excluded() != nullptr ? w.pixels : 0);
    copy_column(left_out.data(), excluded(), left_out.size());
    observe({bounce, rays.view(), hits.view(), slots, left_out.empty() ? nullptr : left_out.data()});
}

}  // namespace ctpbench
