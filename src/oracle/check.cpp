#include "oracle/check.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracle/coverage.h"

namespace ctpbench {

double Verdict::mismatch_rate() const {
    return rays == 0 ? 0.0
                     : static_cast<double>(faults() + leak + reference_wrong + boundary) /
                           static_cast<double>(rays);
}

std::string Verdict::text() const {
    std::string out = std::to_string(rays) + " rays:";
    const auto add = [&](std::size_t n, const char* what) {
        if (n > 0) out += " " + std::to_string(n) + " " + what + ",";
    };
    add(match, "match"), add(tie, "tie"), add(reference_wrong, "reference wrong"), add(boundary, "boundary");
    add(t_mismatch, "t mismatch"), add(wrong_primitive, "wrong primitive"), add(missed, "missed");
    add(false_hit, "false hit"), add(not_finite, "not finite"), add(leak, "leak");
    out.pop_back();
    return out;
}

Verdict& Verdict::operator+=(const Verdict& o) {
    rays += o.rays, match += o.match, tie += o.tie, reference_wrong += o.reference_wrong,
        boundary += o.boundary;
    t_mismatch += o.t_mismatch, wrong_primitive += o.wrong_primitive, missed += o.missed;
    false_hit += o.false_hit, not_finite += o.not_finite, leak += o.leak;
    return *this;
}

ExactHit Judge::exact(std::uint32_t id, const ExactRay& ray) const {
    return id < geometry_.first_sphere() ? exact_hit(geometry_.triangle(id), ray)
                                         : exact_hit(geometry_.spheres[id - geometry_.first_sphere()], ray);
}

bool Judge::surface_goes_on(std::uint32_t id, const ExactHit& exact, const ExactRay& ray) const {
    if (id >= geometry_.first_sphere() || !(exact.t > ExactHit::kTolerance * exact.t_unit)) return false;
    std::call_once(adjacency_made_, [&] { adjacency_ = std::make_unique<const MeshAdjacency>(geometry_); });
    return surface_covers(geometry_, *adjacency_, id, ExactHit::kTolerance * exact.unit, ray);
}

// The contender did not report `id` (nor anything at or before its t) although the reference did.
void Judge::absence(std::uint32_t id, const ExactHit& exact, const Ray& ray, std::size_t& fault,
                    Verdict& verdict) const {
    if (exact.outside())
        ++verdict.reference_wrong;
    else if (exact.inside())
        ++fault;
    else if (surface_goes_on(id, exact, ray))
        ++verdict.leak;
    else
        ++verdict.boundary;
}

double Judge::ray(const Ray& ray, const Hit& ours, const Hit& theirs, Verdict& verdict) const {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    ++verdict.rays;
    const bool we_hit = ours.primitive != kNoPrimitive, they_hit = theirs.primitive != kNoPrimitive;
    if (!we_hit && !they_hit) {
        ++verdict.match;
        return none;
    }
    if (!we_hit) {
        absence(theirs.primitive, exact(theirs.primitive, ray), ray, verdict.missed, verdict);
        return none;
    }
    if (!(std::isfinite(ours.t) && std::isfinite(ours.u) && std::isfinite(ours.v))) {
        ++verdict.not_finite;
        return none;
    }
    const ExactHit a = exact(ours.primitive, ray);
    if (a.outside()) {
        ++verdict.false_hit;
        return none;
    }
    const double error = a.t_error(ours.t);
    if (!(error <= ExactHit::kTolerance)) {
        ++verdict.t_mismatch;
        return error;
    }
    if (ours.primitive == theirs.primitive) {
        ++verdict.match;
        return error;
    }
    if (!they_hit) {
        ++(a.inside() ? verdict.reference_wrong : verdict.boundary);
        return error;
    }
    const ExactHit b = exact(theirs.primitive, ray);
    const double at = a.t_nearest(ours.t);
    if (std::fabs(at - b.t) <= ExactHit::kTolerance * (a.t_unit + b.t_unit) && !b.outside())
        ++verdict.tie;
    else if (at < b.t)
        ++(a.inside() && at == a.t ? verdict.reference_wrong : verdict.boundary);
    else
        absence(theirs.primitive, b, ray, verdict.wrong_primitive, verdict);
    return error;
}

Verdict Judge::batch(Batch& batch, HitColumns contender, HitColumns reference, std::uint32_t sample) const {
    Verdict verdict;
    const auto rays = static_cast<std::uint32_t>(batch.rays.size());
    const RayColumns columns = batch.rays.view();
    const std::uint32_t judged = sample == 0 ? rays : std::min(sample, rays);
    for (std::uint32_t i = 0; i < judged; ++i) {
        const auto at = static_cast<std::uint32_t>(std::uint64_t{i} * rays / judged);
        ray(columns.load(at), contender.load(at), reference.load(at), verdict);
    }
    return verdict;
}

}  // namespace ctpbench
