// What a tracer answers to given rays, counted against the oracle of last resort: the reference is found
// once, then any number of tracers are judged by it.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "oracle/exact_tracer.h"
#include "stress/workload.h"
#include "wavefront/batch_tracer.h"

namespace ctpbench {

class CpuBackend;

struct Accuracy {
    Verdict verdict;
    double p99_scaled_error = 0.0;  // of t (ExactHit::t_error), nearest rank; NaN if nothing was hit

    std::size_t failures() const { return verdict.faults() + verdict.leak; }
};

// Called between slices of work; may throw to end it.
using SafePoint = std::function<void()>;

// Rays 0 to n - 1 as a batch.
Batch stress_batch(CpuBackend& backend, std::uint32_t n, const std::function<Ray(std::uint32_t)>& ray);

// Closest hits of rays. What it is made from must outlive it.
class RayExam {
public:
    // Traces the batch exactly.
    RayExam(CpuBackend& backend, const Judge& judge, const ExactTracer& exact, Batch& batch,
            const SafePoint& safe_point);

    Accuracy take(BatchTracer& tracer);

private:
    CpuBackend& backend_;
    const Judge& judge_;
    Batch& batch_;
    HitStorage reference_;
};

// Paths that leave surfaces: their rays are formed by a policy of offsets, the truth is that of the ideal
// path. What it is made from must outlive it.
class DepartureExam {
public:
    // Where a policy starts the ray.
    using Policy = std::function<Vec3(const Departure&)>;

    // Traces n ideal paths of the workload exactly.
    DepartureExam(CpuBackend& backend, const Judge& judge, const ExactTracer& exact,
                  const StressWorkload& workload, std::uint32_t n, const SafePoint& safe_point);

    // A self-hit, where the ideal path hits nothing or far later, is a false hit; nothing where it hits
    // something is missed; another surface than the ideal path's is a wrong primitive. The error of t is not
    // judged: an offset moves every hit.
    Accuracy take(BatchTracer& tracer, Batch& batch) const;

    // The rays of a policy, each with the primitive that it starts on: methods that exclude leave that out.
    Batch batch(const Policy& policy) const;

private:
    void judge_path(const Departure& path, const ExactClosest& truth, const Ray& ray, const Hit& hit,
                    Verdict& verdict) const;

    CpuBackend& backend_;
    const Judge& judge_;
    const StressWorkload& workload_;
    std::vector<Departure> departures_;
    std::vector<ExactClosest> truth_;
};

// The policy of one of offsets() (wavefront/methods.h).
DepartureExam::Policy offset_policy(const std::string& offset);

}  // namespace ctpbench
