// The settings of a config that are one number under a key of their own: where they are kept and what they
// may be. The reader and the schema take both from here.
#pragma once

#include "base/json_reader.h"
#include "config/config.h"

namespace ctpbench {

// What every study has: calls f(key, member, allowed, help) for each.
template <class F>
void for_each_setting(F&& f) {
    f("width", &Config::width, range(1, max_image_side), "Pixels of a frame");
    f("height", &Config::height, range(1, max_image_side), "Pixels of a frame");
    f("bounces", &Config::bounces, range(1, max_bounces), "Intersections of a path after the camera ray's");
    f("rounds", &Config::rounds, range(1, max_rounds), "Times that each contender is measured at least");
    f("min_time", &Config::min_time, range(0, max_seconds), "The least seconds of rounds of a contest");
    f("max_noise", &Config::max_noise, range(0, 1),
      "Rounds go on until each interval's half-width is this share of its ratio; 0: no matter");
    f("timeout", &Config::timeout, range(0, max_seconds),
      "The most seconds of rounds of a contest; 0: no limit");
    f("seed", &Config::seed, Range{}, "Of every random number");
    f("threads", &Config::threads, range(0, max_threads), "0: all that the machine allows");
    f("batch_rays", &Config::batch_rays, range(0, max_rays), "Rays timed of each bounce; 0: all");
    f("oracle_rays", &Config::oracle_rays, range(1, max_rays), "Rays of each bounce that the oracle checks");
}

// What one study has: calls f(study, key, member, allowed, help) for each.
template <class F>
void for_each_study_setting(F&& f) {
    f(Study::stability, "stress_rays", &Config::stress_rays, range(1, max_rays),
      "Of a stability study or table pareto: rays of each workload");
    f(Study::convergence, "seeds", &Config::seeds, range(2, 1000),
      "Of a convergence study: independent pictures of each contender");
    f(Study::convergence, "samples", &Config::samples, range(64, 1u << 20),
      "Of a convergence study: paths per pixel of the last picture, a power of two");
    f(Study::convergence, "reference_samples", &Config::reference_samples, range(2, 1u << 24),
      "Of a convergence study: paths per pixel of the picture that errors are taken from");
}

}  // namespace ctpbench
