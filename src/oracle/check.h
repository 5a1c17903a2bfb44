// Verdicts on hits: a contender's against Embree's, with float64 as the judge where they differ.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "kernels/primitives/geometry.h"
#include "wavefront/batch.h"

namespace ctpbench {

// Counts of sampled rays. Those above `boundary` are sound; the ones below are the contender's faults.
struct Verdict {
    std::size_t rays = 0;
    std::size_t match = 0;            // the same primitive, t within its scaled error
    std::size_t tie = 0;              // another primitive at the same t, within the errors of both
    std::size_t reference_wrong = 0;  // Embree missed the nearer hit, or hit what is not there
    std::size_t boundary = 0;         // the ray grazes a rim or a silhouette, where either answer is right
    std::size_t t_mismatch = 0;       // the right primitive at the wrong t
    std::size_t wrong_primitive = 0;
    std::size_t missed = 0;
    std::size_t false_hit = 0;
    std::size_t leak = 0;  // passed between two triangles that share an edge

    std::size_t faults() const { return t_mismatch + wrong_primitive + missed + false_hit; }
    // Whether the contender may be timed. Leaks are faults of an exact bundle of methods; others are known
    // to leak, and the count is reported.
    bool accepted(bool exact_methods) const { return faults() == 0 && (!exact_methods || leak == 0); }
    // Share of rays that differ from the reference beyond rounding.
    double mismatch_rate() const;
    // "20000 rays: 19990 match, 10 tie"
    std::string text() const;
    Verdict& operator+=(const Verdict& other);
};

// Judges about `sample` rays of the batch (0: all), spread evenly.
Verdict judge(Batch& batch, HitColumns contender, HitColumns reference, const GeometryView& geometry,
              std::uint32_t sample);

// Judges one ray; adds to the verdict.
void judge_ray(const Ray& ray, const Hit& contender, const Hit& reference, const GeometryView& geometry,
               Verdict& verdict);

}  // namespace ctpbench
