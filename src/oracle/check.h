// Verdicts on hits: a contender's against a reference's, with float64 as the judge where they differ. The
// reference is Embree in contests of speed, and the exact tracer (oracle/exact_tracer.h) in studies of
// accuracy.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "kernels/primitives/geometry.h"
#include "oracle/adjacency.h"
#include "oracle/exact.h"
#include "wavefront/batch.h"

namespace ctpbench {

// Counts of sampled rays. Those up to `boundary` are sound; the ones below are the contender's faults.
struct Verdict {
    std::size_t rays = 0;
    std::size_t match = 0;            // the same primitive, t within its scaled error
    std::size_t tie = 0;              // another primitive at the same t, within the errors of both
    std::size_t reference_wrong = 0;  // it missed the nearer hit, or hit what is not there
    std::size_t boundary = 0;  // the ray grazes a rim or a silhouette or starts on a surface: either is right
    std::size_t t_mismatch = 0;  // the right primitive at the wrong t
    std::size_t wrong_primitive = 0;
    std::size_t missed = 0;
    std::size_t false_hit = 0;
    std::size_t not_finite = 0;  // a hit with a t, u or v that is NaN or infinite
    std::size_t leak = 0;        // passed between triangles that share an edge or a vertex

    std::size_t faults() const { return t_mismatch + wrong_primitive + missed + false_hit + not_finite; }
    // Whether the contender may be timed. Leaks are faults of an exact bundle of methods; others are known
    // to leak, and the count is reported.
    bool accepted(bool exact_methods) const { return faults() == 0 && (!exact_methods || leak == 0); }
    // Share of rays that differ from the reference beyond rounding.
    double mismatch_rate() const;
    // "20000 rays: 19990 match, 10 tie"
    std::string text() const;
    Verdict& operator+=(const Verdict& other);
    bool operator==(const Verdict&) const = default;
};

// Judges rays in one scene. May be used from many threads at once.
class Judge {
public:
    // What `geometry` views must outlive it.
    explicit Judge(const GeometryView& geometry) : geometry_(geometry) {}

    // Judges one ray; adds to the verdict. Returns the scaled error of the contender's t (ExactHit::t_error),
    // or NaN if it reported no hit, one that is not finite, or one that is not there.
    double ray(const Ray& ray, const Hit& contender, const Hit& reference, Verdict& verdict) const;
    // About `sample` rays of the batch (0: all), spread evenly.
    Verdict batch(Batch& batch, HitColumns contender, HitColumns reference, std::uint32_t sample) const;

    ExactHit exact(std::uint32_t primitive, const ExactRay& ray) const;
    // Whether a ray that passes this primitive's outline within rounding cannot miss the surface there: other
    // triangles continue it all around. `exact` is the primitive's own hit.
    bool surface_goes_on(std::uint32_t primitive, const ExactHit& exact, const ExactRay& ray) const;
    const GeometryView& geometry() const { return geometry_; }

private:
    void absence(std::uint32_t primitive, const ExactHit& exact, const Ray& ray, std::size_t& fault,
                 Verdict& verdict) const;

    GeometryView geometry_;
    mutable std::once_flag adjacency_made_;  // on first need: most scenes' rays ask for none
    mutable std::unique_ptr<const MeshAdjacency> adjacency_;
};

}  // namespace ctpbench
