#include "oracle/check.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "oracle/exact.h"

namespace ctpbench {
namespace {

ExactHit exact_hit_of(const GeometryView& geometry, std::uint32_t id, const Ray& ray) {
    return id < geometry.first_sphere() ? exact_hit(geometry.triangle(id), ray)
                                        : exact_hit(geometry.spheres[id - geometry.first_sphere()], ray);
}

// Whether another triangle continues the surface across the edge (a, b) of `id`, as seen along the ray:
// only then is it a fault to hit neither.
bool surface_continues(const GeometryView& geometry, std::uint32_t id, Vec3 a, Vec3 b, Vec3 opposite,
                       const Ray& ray) {
    const auto side = [&](Vec3 p) {
        // Which side of the plane through the edge and the ray's direction p lies on.
        const Vec3 n = cross(ray.direction, b - a);
        return dot(n, p - a) > 0.0f;
    };
    for (std::uint32_t i = 0; i < geometry.triangle_count; ++i) {
        if (i == id) continue;
        const TriangleShape t = geometry.triangle(i);
        const int of_a = t.a == a ? 0 : t.b == a ? 1 : t.c == a ? 2 : -1;
        const int of_b = t.a == b ? 0 : t.b == b ? 1 : t.c == b ? 2 : -1;
        if (of_a < 0 || of_b < 0 || of_a == of_b) continue;
        const int third = 3 - of_a - of_b;
        if (side(third == 0 ? t.a : third == 1 ? t.b : t.c) != side(opposite)) return true;
    }
    return false;
}

// A ray that grazes this primitive's outline missed it: is there a surface that it should have hit?
bool is_leak(const GeometryView& geometry, std::uint32_t id, const ExactHit& exact, const Ray& ray) {
    if (id >= geometry.first_sphere()) return false;
    const TriangleShape t = geometry.triangle(id);
    const std::pair<Vec3, Vec3> edges[] = {{t.b, t.c}, {t.c, t.a}, {t.a, t.b}};
    const Vec3 opposite[] = {t.a, t.b, t.c};
    for (int e = 0; e < 3; ++e) {
        if (std::fabs(edge_distance(edges[e].first, edges[e].second, ray)) >
            ExactHit::kTolerance * exact.unit)
            continue;
        if (!surface_continues(geometry, id, edges[e].first, edges[e].second, opposite[e], ray)) return false;
    }
    return true;
}

// The contender did not report `id` (nor anything at or before its t) although the reference did.
void judge_absence(const GeometryView& geometry, std::uint32_t id, const ExactHit& exact, const Ray& ray,
                   std::size_t& fault, Verdict& verdict) {
    if (exact.outside())
        ++verdict.reference_wrong;
    else if (exact.inside())
        ++fault;
    else if (is_leak(geometry, id, exact, ray))
        ++verdict.leak;
    else
        ++verdict.boundary;
}

}  // namespace

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
    add(false_hit, "false hit"), add(leak, "leak");
    out.pop_back();
    return out;
}

Verdict& Verdict::operator+=(const Verdict& o) {
    rays += o.rays, match += o.match, tie += o.tie, reference_wrong += o.reference_wrong,
        boundary += o.boundary;
    t_mismatch += o.t_mismatch, wrong_primitive += o.wrong_primitive, missed += o.missed;
    false_hit += o.false_hit, leak += o.leak;
    return *this;
}

void judge_ray(const Ray& ray, const Hit& ours, const Hit& theirs, const GeometryView& geometry,
               Verdict& verdict) {
    ++verdict.rays;
    const bool we_hit = ours.primitive != kNoPrimitive, they_hit = theirs.primitive != kNoPrimitive;
    if (!we_hit && !they_hit) {
        ++verdict.match;
        return;
    }
    if (!we_hit) {
        judge_absence(geometry, theirs.primitive, exact_hit_of(geometry, theirs.primitive, ray), ray,
                      verdict.missed, verdict);
        return;
    }
    const ExactHit a = exact_hit_of(geometry, ours.primitive, ray);
    if (a.outside()) {
        ++verdict.false_hit;
        return;
    }
    if (!(a.t_error(ours.t) <= ExactHit::kTolerance)) {
        ++verdict.t_mismatch;
        return;
    }
    if (ours.primitive == theirs.primitive) {
        ++verdict.match;
        return;
    }
    if (!they_hit) {
        ++(a.inside() ? verdict.reference_wrong : verdict.boundary);
        return;
    }
    const ExactHit b = exact_hit_of(geometry, theirs.primitive, ray);
    if (std::fabs(a.t - b.t) <= ExactHit::kTolerance * (a.t_unit + b.t_unit) && !b.outside())
        ++verdict.tie;
    else if (a.t < b.t)
        ++(a.inside() ? verdict.reference_wrong : verdict.boundary);
    else
        judge_absence(geometry, theirs.primitive, b, ray, verdict.wrong_primitive, verdict);
}

Verdict judge(Batch& batch, HitColumns contender, HitColumns reference, const GeometryView& geometry,
              std::uint32_t sample) {
    Verdict verdict;
    const auto rays = static_cast<std::uint32_t>(batch.rays.size());
    const RayColumns columns = batch.rays.view();
    const std::uint32_t judged = sample == 0 ? rays : std::min(sample, rays);
    for (std::uint32_t i = 0; i < judged; ++i) {
        const auto at = static_cast<std::uint32_t>(std::uint64_t{i} * rays / judged);
        judge_ray(columns.load(at), contender.load(at), reference.load(at), geometry, verdict);
    }
    return verdict;
}

}  // namespace ctpbench
