#include "measure/exam.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "backends/cpu.h"
#include "kernels/methods/lists.h"
#include "measure/judged.h"
#include "measure/statistics.h"

namespace ctpbench {
namespace {

constexpr std::uint32_t kSlice = 65536;  // rays between two safe points: a fraction of a second

// each(i) for i in 0..n-1 on all threads, slice by slice.
template <class Each>
void in_slices(CpuBackend& backend, std::uint32_t n, const SafePoint& safe_point, const Each& each) {
    for (std::uint32_t first = 0; first < n; first += kSlice) {
        safe_point();
        backend.for_each(
            std::min(kSlice, n - first), [&, first](std::uint32_t i) { each(first + i); }, 256);
    }
}

std::uint32_t size_of(const Batch& batch) { return static_cast<std::uint32_t>(batch.rays.size()); }

}  // namespace

Batch stress_batch(CpuBackend& backend, std::uint32_t n, const std::function<Ray(std::uint32_t)>& ray) {
    Batch batch;
    batch.active = n;
    batch.rays.resize(n);
    batch.index.resize(n);
    batch.slots.resize(n);
    std::iota(batch.index.begin(), batch.index.end(), 0u);
    std::iota(batch.slots.begin(), batch.slots.end(), 0u);
    const RayColumns columns = batch.rays.view();
    backend.for_each(n, [&](std::uint32_t i) { columns.store(i, ray(i)); });
    return batch;
}

RayExam::RayExam(CpuBackend& backend, const Judge& judge, const ExactTracer& exact, Batch& batch,
                 const SafePoint& safe_point)
    : backend_(backend), judge_(judge), batch_(batch) {
    const std::uint32_t n = size_of(batch);
    reference_.resize(n);
    const HitColumns hits = reference_.view();
    const RayColumns rays = batch.rays.view();
    in_slices(backend, n, safe_point, [&](std::uint32_t i) { hits.store(i, exact.reference(rays.load(i))); });
}

Accuracy RayExam::take(BatchTracer& tracer) {
    tracer.trace(batch_, true);
    const std::uint32_t n = size_of(batch_);
    const HitColumns hits = tracer.hits().view(), reference = reference_.view();
    const RayColumns rays = batch_.rays.view();
    std::vector<float> errors(n);
    Accuracy accuracy;
    accuracy.verdict = judged(backend_, n, [&](std::uint32_t i, Verdict& verdict) {
        errors[i] = static_cast<float>(judge_.ray(rays.load(i), hits.load(i), reference.load(i), verdict));
    });
    accuracy.p99_scaled_error = nearest_rank(std::move(errors), 0.99);
    return accuracy;
}

DepartureExam::DepartureExam(CpuBackend& backend, const Judge& judge, const ExactTracer& exact,
                             const StressWorkload& workload, std::uint32_t n, const SafePoint& safe_point)
    : backend_(backend), judge_(judge), workload_(workload), departures_(n), truth_(n) {
    in_slices(backend, n, safe_point, [&](std::uint32_t i) {
        const Departure& d = departures_[i] = workload.departure(i);
        const Vec3 along = d.direction;
        truth_[i] = exact.after_departure({d.exact, {along.x, along.y, along.z}}, d.primitive);
    });
}

Batch DepartureExam::batch(const Policy& policy) const {
    const auto n = static_cast<std::uint32_t>(departures_.size());
    Batch batch = stress_batch(backend_, n, [&](std::uint32_t i) {
        const Departure& d = departures_[i];
        return Ray{policy(d), d.direction, std::numeric_limits<float>::infinity()};
    });
    for (const Departure& d : departures_) batch.excluded.push_back(d.primitive);
    return batch;
}

Accuracy DepartureExam::take(BatchTracer& tracer, Batch& batch) const {
    const auto n = static_cast<std::uint32_t>(departures_.size());
    tracer.trace(batch, true);
    const HitColumns hits = tracer.hits().view();
    const RayColumns rays = batch.rays.view();
    Accuracy accuracy;
    accuracy.verdict = judged(backend_, n, [&](std::uint32_t i, Verdict& verdict) {
        judge_path(departures_[i], truth_[i], rays.load(i), hits.load(i), verdict);
    });
    accuracy.p99_scaled_error = std::numeric_limits<double>::quiet_NaN();
    return accuracy;
}

void DepartureExam::judge_path(const Departure& path, const ExactClosest& truth, const Ray& ray,
                               const Hit& hit, Verdict& verdict) const {
    ++verdict.rays;
    const bool hits = hit.primitive != kNoPrimitive, should = truth.primitive != kNoPrimitive;
    if (!hits) {
        ++(should ? verdict.missed : verdict.match);
        return;
    }
    if (!(std::isfinite(hit.t) && std::isfinite(hit.u) && std::isfinite(hit.v))) {
        ++verdict.not_finite;
        return;
    }
    double moved = 0.0;
    for (int a = 0; a < 3; ++a)
        moved += std::fabs(double{ray.origin[a]} - path.exact[static_cast<std::size_t>(a)]);
    // Nothing that is left from can be met again in less than half of the way that the ideal path has, unless
    // the offset is of the length of that way.
    const bool flat = hit.primitive < judge_.geometry().first_sphere();
    const bool returned = flat ? hit.primitive == path.primitive : false;
    const bool too_early = should && truth.t > 4.0 * moved && hit.t < 0.5 * truth.t;
    if (!should || returned || too_early)
        ++verdict.false_hit;
    else if (workload_.surfaces[hit.primitive] != workload_.surfaces[truth.primitive])
        ++verdict.wrong_primitive;
    else
        ++(hit.primitive == truth.primitive ? verdict.match : verdict.tie);
}

DepartureExam::Policy offset_policy(const std::string& offset) {
    DepartureExam::Policy policy;
    for_each_type(Offsets{}, [&](auto tag) {
        using Offset = typename decltype(tag)::type;
        if (offset == Offset::name)
            policy = [](const Departure& d) { return Offset::origin(d.point, d.normal, d.direction, d.t); };
    });
    if (!policy) trap();
    return policy;
}

}  // namespace ctpbench
