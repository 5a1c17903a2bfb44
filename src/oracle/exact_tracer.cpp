#include "oracle/exact_tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ctpbench {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The slab test with every slab widened by `pad`.
class WidenedBox {
public:
    WidenedBox(const ExactRay& ray, double extent) {
        double largest = extent;
        for (const double o : ray.origin) largest = std::max(largest, std::fabs(o));
        // A primitive within kTolerance units is undecided, and no coordinate relative to the origin exceeds
        // twice this; a sphere adds its radius.
        pad_ = 4.0 * ExactHit::kTolerance * 0x1p-24 * largest;
        for (int a = 0; a < 3; ++a) {
            origin_[a] = ray.origin[a];
            // Finite reciprocals keep 0 times infinity out of the products.
            inverse_[a] = 1.0 / (ray.direction[a] == 0.0 ? 1e-300 : ray.direction[a]);
        }
    }
    // Where the line enters, at least 0; infinity if it does not.
    double enter(const BvhNode& node) const {
        double near = 0.0, far = kInfinity;
        for (int a = 0; a < 3; ++a) {
            const double lo = (node.bounds[a] - pad_ - origin_[a]) * inverse_[a];
            const double hi = (node.bounds[a + 3] + pad_ - origin_[a]) * inverse_[a];
            near = std::max(near, std::min(lo, hi));
            far = std::min(far, std::max(lo, hi));
        }
        return near <= far ? near : kInfinity;
    }

private:
    double origin_[3], inverse_[3], pad_;
};

struct Candidate {
    std::uint32_t id;
    ExactHit hit;
};

}  // namespace

ExactTracer::ExactTracer(const Judge& judge, const Tree& tree) : judge_(judge), tree_(tree), extent_(0.0) {
    if (tree.nodes.empty()) return;
    for (const float b : tree.nodes[0].bounds) extent_ = std::max(extent_, std::fabs(double{b}));
}

// Calls test(id) for every primitive whose leaf the ray meets before `bound`, which the call may lower; for
// one in several leaves more than once.
template <class Test>
void ExactTracer::for_each_met(const ExactRay& ray, const double& bound, const Test& test) const {
    if (tree_.nodes.empty()) return;
    const WidenedBox box(ray, extent_);
    struct Entry {
        std::uint32_t node;
        double near;
    };
    Entry stack[kMaxTreeDepth + 1];
    std::uint32_t top = 0;
    stack[top++] = {0, box.enter(tree_.nodes[0])};
    while (top > 0) {
        const Entry entry = stack[--top];
        if (!(entry.near <= bound) || entry.near == kInfinity) continue;
        const BvhNode& node = tree_.nodes[entry.node];
        if (node.is_leaf()) {
            for (std::uint32_t i = node.first; i < node.first + node.count(); ++i) {
                const PrimitiveRef ref = tree_.refs[i];
                test(ref.type == 0 ? ref.index : judge_.geometry().first_sphere() + ref.index);
            }
            continue;
        }
        const Entry a{node.first, box.enter(tree_.nodes[node.first])};
        const Entry b{node.first + 1, box.enter(tree_.nodes[node.first + 1])};
        stack[top++] = a.near < b.near ? b : a;
        stack[top++] = a.near < b.near ? a : b;
    }
}

ExactClosest ExactTracer::closest(const ExactRay& ray) const {
    ExactClosest best;
    best.t = kInfinity;
    std::vector<Candidate> undecided;
    double bound = kInfinity;  // what begins after this is certainly behind the decided hit
    for_each_met(ray, bound, [&](std::uint32_t id) {
        const ExactHit hit = judge_.exact(id, ray);
        if (hit.outside()) return;
        if (!hit.inside()) {
            undecided.push_back({id, hit});
        } else if (hit.t < best.t || (hit.t == best.t && id < best.primitive)) {
            best = {id, hit.t, true};
            bound = hit.t + ExactHit::kTolerance * hit.t_unit;
        }
    });
    std::sort(undecided.begin(), undecided.end(), [](const Candidate& a, const Candidate& b) {
        return a.hit.t < b.hit.t || (a.hit.t == b.hit.t && a.id < b.id);
    });
    for (const Candidate& c : undecided) {
        if (!(c.hit.t < best.t)) break;
        if (judge_.surface_goes_on(c.id, c.hit, ray)) return {c.id, c.hit.t, false};
    }
    return best;
}

ExactClosest ExactTracer::after_departure(const ExactRay& ray, std::uint32_t start) const {
    ExactClosest best;
    best.t = kInfinity;
    for_each_met(ray, best.t, [&](std::uint32_t id) {
        const bool starts_here = id == start;
        if (starts_here && id < judge_.geometry().first_sphere()) return;
        const ExactHit hit = judge_.exact(id, ray);
        if (starts_here ? !hit.inside() : !(hit.margin >= 0.0 && hit.t > 0.0)) return;
        if (hit.t < best.t || (hit.t == best.t && id < best.primitive)) best = {id, hit.t, true};
    });
    return best;
}

Hit ExactTracer::reference(const Ray& ray) const {
    const ExactClosest hit = closest(ray);
    if (hit.primitive == kNoPrimitive) return no_hit(ray);
    return {static_cast<float>(hit.t), hit.primitive, 0.0f, 0.0f};
}

}  // namespace ctpbench
