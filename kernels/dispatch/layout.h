// What strategies build their layouts from: the trees of one scene, and its geometry. All of it is the
// caller's and outlives the layout.
#pragma once

#include <cstddef>
#include <vector>

#include "../array.h"
#include "../bvh.h"
#include "../intersect.h"
#include "../primitives/list.h"
#include "../slot.h"
#include "../synthetic/types.h"
#include "place.h"

namespace ctpbench {

struct TreeView {
    const BvhNode* nodes = nullptr;
    const PrimitiveRef* refs = nullptr;
    std::size_t node_count = 0;
    std::size_t ref_count = 0;
};

// Which trees a strategy traverses.
enum class TreeKind {
    mixed,         // one tree, leaves of any mixture
    typed_leaves,  // one tree, a leaf holds one type
    per_type,      // a tree for each type
};

struct LayoutInput {
    TreeView mixed;
    TreeView typed_leaves;
    std::vector<TreeView> per_type;  // by tag
    GeometryView geometry;
    std::uint32_t types = kAllPrimitives;  // a mask: whoever is laid out is compiled for these primitives
    SyntheticTypes synthetic{};            // in their place, if there are any
};

// For strategies that need one pass only. A tree over nothing has no root to start from.
template <class Methods, class View, class ForEach>
void intersect_in_one_pass(const View& view, const IntersectBuffers& io, ForEach&& for_each) {
    if (view.nodes == nullptr)
        for_each(io.count, MissKernel{io});
    else
        for_each(io.count, IntersectKernel<Methods, View>{view, io});
}

}  // namespace ctpbench
