#include "monomorphic/races.h"

#include <cstring>

#include "measure/rounds.h"
#include "wavefront/cpu_tracer.h"
#include "wavefront/renderer.h"

namespace ctpbench::monomorphic {
namespace {

Race race_of(const std::vector<std::string>& names) {
    Race race;
    for (const std::string& name : names) race.racers.push_back({name, {}});
    return race;
}

}  // namespace

std::vector<Batch> record_bounces(Stage& stage, const FrameSettings& settings, std::uint32_t limit) {
    std::vector<Batch> batches;
    Renderer renderer(stage.backend, stage.view, stage.scene.camera, settings);
    ImageStorage image;
    renderer.frame(*intersector_of(stage, kByHand), *shader_of(stage, kByHand), true, 0, image,
                   [&](const BounceView& view) {
                       Batch& batch =
                           batches.emplace_back(record_batch(view.bounce, view.rays, view.slots, limit));
                       batch.hit_hash = record_hits(batch, view.hits).hash();
                   });
    return batches;
}

Race race_intersect(Stage& stage, const std::vector<std::string>& names, std::vector<Batch>& batches,
                    std::uint32_t rounds) {
    Race race = race_of(names);
    std::vector<std::unique_ptr<Intersector>> intersectors;
    std::vector<CpuTracer> tracers;
    for (const std::string& name : names) {
        intersectors.push_back(intersector_of(stage, name));
        tracers.emplace_back(stage.backend, *intersectors.back(), stage.view.geometry().extent);
        for (Batch& batch : batches)  // which also warms up
            if (tracers.back().trace(batch, true).hash != batch.hit_hash)
                throw Differ("intersect: the hits of " + name + " at bounce " + std::to_string(batch.bounce) +
                             " are others");
    }
    for (const Batch& batch : batches) race.paths += batch.rays.size();
    for (std::uint32_t round = 0; round < rounds; ++round) {
        for (Racer& racer : race.racers) racer.seconds.push_back(0.0);
        for (std::size_t b = 0; b < batches.size(); ++b)
            for (const std::size_t c : round_order(names.size(), round + b)) {
                const auto [seconds, hash] = tracers[c].trace(batches[b], true);
                if (hash != batches[b].hit_hash) throw Differ("intersect: hits changed between two runs");
                race.racers[c].seconds.back() += seconds;
            }
    }
    return race;
}

Race race_shade(Stage& stage, const std::vector<std::string>& names, const FrameSettings& settings,
                std::uint32_t rounds) {
    Race race = race_of(names);
    const auto intersector = intersector_of(stage, "ctp");
    std::vector<std::unique_ptr<Shader>> shaders;
    for (const std::string& name : names) shaders.push_back(shader_of(stage, name));
    Renderer renderer(stage.backend, stage.view, stage.scene.camera, settings);
    std::vector<ImageStorage> images(names.size());
    for (std::uint32_t sample = 0; sample <= rounds; ++sample) {  // the first one warms up
        for (const std::size_t c : round_order(names.size(), sample)) {
            double seconds = 0.0;
            std::uint64_t paths = 0;
            for (const StageTime& stage_time :
                 renderer.frame(*intersector, *shaders[c], true, sample, images[c], {})) {
                if (std::strcmp(stage_time.kernel, "shade") != 0) continue;
                seconds += stage_time.seconds, paths += stage_time.rays;
            }
            if (sample == 0) continue;
            race.racers[c].seconds.push_back(seconds);
            race.paths = paths;
        }
        for (std::size_t c = 1; c < names.size(); ++c)
            if (images[c].hash() != images[0].hash())
                throw Differ("shade: the image of " + names[c] + " after " + std::to_string(sample + 1) +
                             " samples is another one");
    }
    return race;
}

}  // namespace ctpbench::monomorphic
