#include "monomorphic/triangle_intersector.h"

#include <stdexcept>

namespace ctpbench::monomorphic {
namespace {

struct ClosestHitKernel {
    const BvhNode* nodes;
    const LeafTriangle* triangles;
    RayColumns rays;
    HitColumns hits;
    const std::uint32_t* index;
    float extent;

    void operator()(std::uint32_t i) const {
        const std::uint32_t slot = index[i];
        hits.store(slot, closest_hit(rays.load(slot)));
    }

private:
    CTP_INLINE void prefetch_below(const BvhNode& node) const {
        prefetch(node.is_leaf() ? static_cast<const void*>(triangles + node.first) : nodes + node.first);
    }

    // Front to back; both children are tested from their parent's step, and chosen among without a branch.
    CTP_INLINE Hit closest_hit(const Ray& ray) const {
        const PaddedBox::RaySetup box = PaddedBox::setup(ray, extent);
        const WatertightTriangle::RaySetup sheared = WatertightTriangle::setup(ray);
        Hit hit = no_hit(ray);
        struct Postponed {
            std::uint32_t node;
            float near;
        };
        Postponed stack[kMaxTreeDepth];
        std::uint32_t top = 0;

        const BvhNode* node = nodes;
        float root_near;
        if (!PaddedBox::test(*node, box, hit.t, root_near)) return hit;
        while (true) {
            bool any = true;
            while (!node->is_leaf()) {
                const std::uint32_t first = node->first;
                const BvhNode* pair = nodes + first;
                prefetch_below(pair[0]);
                prefetch_below(pair[1]);
                float near0, near1;
                const bool hit0 = PaddedBox::test(pair[0], box, hit.t, near0);
                const bool hit1 = PaddedBox::test(pair[1], box, hit.t, near1);
                any = hit0 | hit1;
                if (!any) break;
                const std::uint32_t next = static_cast<std::uint32_t>(hit1) & (!hit0 | (near1 < near0));
                stack[top] = {first + (next ^ 1u), next ? near0 : near1};
                top += static_cast<std::uint32_t>(hit0 & hit1);
                node = pair + next;
            }
            if (any) {
                const LeafTriangle* t = triangles + node->first;
                const LeafTriangle* end = t + node->count();
                do {
                    WatertightTriangle::intersect(t->shape, t->id, sheared, hit);
                } while (++t != end);
            }
            do {
                if (top == 0) return hit;
                --top;
            } while (stack[top].near > hit.t);
            node = nodes + stack[top].node;
        }
    }
};

}  // namespace

TriangleIntersector::TriangleIntersector(const LayoutInput& input) : nodes_(input.mixed.nodes) {
    triangles_.reserve(input.mixed.ref_count);
    for (std::size_t i = 0; i < input.mixed.ref_count; ++i) {
        const PrimitiveRef ref = input.mixed.refs[i];
        if (ref.type != 0) throw std::invalid_argument("the scene has primitives that are not triangles");
        triangles_.push_back({WatertightTriangle::shape(input.geometry.triangle(ref.index)), ref.index});
    }
}

void TriangleIntersector::intersect(CpuBackend& backend, const IntersectBuffers& io, bool) const {
    if (io.keys.keys != nullptr || io.segment_counts != nullptr)
        throw std::invalid_argument("by hand, paths are neither sorted nor queued");
    if (triangles_.empty())
        backend.for_each(io.count, MissKernel{io});
    else
        backend.for_each(io.count,
                         ClosestHitKernel{nodes_, triangles_.data(), io.rays, io.hits, io.index, io.extent});
}

}  // namespace ctpbench::monomorphic
