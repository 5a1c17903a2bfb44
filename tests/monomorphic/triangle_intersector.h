// The intersect stage of a renderer that has triangles and nothing else, written by hand: what strategies
// should cost once they are narrowed to a list of that one type. No tag, variant, visitor or list of types is
// in it. It is the algorithm of kernels/traverse.h over the same tree, and the arithmetic is the shared one,
// so that the two may differ in time but not in a bit of their hits.
#pragma once

#include "wavefront/intersector.h"

namespace ctpbench::monomorphic {

// 40 bytes, in leaf order; a spatially split triangle is there once per reference.
struct LeafTriangle {
    WatertightTriangle::Shape shape;
    std::uint32_t id;
};

class TriangleIntersector final : public Intersector {
public:
    // Over the mixed tree, which must outlive it, as strategy `ctp`. Throws if there is a sphere in it.
    explicit TriangleIntersector(const LayoutInput& input);

    // Serves shaders that take paths as traced alone: throws if keys or queues are asked for.
    void intersect(CpuBackend& backend, const IntersectBuffers& io, bool carry_t) const override;
    std::size_t bytes() const override { return triangles_.size() * sizeof(LeafTriangle); }

private:
    const BvhNode* nodes_;
    Array<LeafTriangle> triangles_;
};

}  // namespace ctpbench::monomorphic
