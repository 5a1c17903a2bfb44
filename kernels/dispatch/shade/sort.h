// The paper's sorting: paths are sorted by the type of the material they hit, and each type has a kernel of
// its own, which knows the type of all of its paths.
//
// `sort` reorders the index of the wavefront itself, as the paper does. Bounce by bounce its neighbours come
// from farther apart, and each touches cache lines of its own in every column. `sort_restored` sorts
// positions in the index instead: shading sees the same kernels, and the wavefront keeps the order of its
// pixels.
#pragma once

#include "typed_materials.h"

namespace ctpbench {

// The paths of one key, in sorted order.
template <PathOrder order>
struct SortedPaths {
    ShadeBuffers io;
    const std::uint32_t* positions;
    std::uint32_t first;

    CTP_INLINE std::uint32_t position(std::uint32_t i) const {
        return order == PathOrder::restored ? positions[first + i] : first + i;
    }
    CTP_INLINE std::uint32_t slot(std::uint32_t i) const { return io.index[position(i)]; }
    CTP_INLINE void end(std::uint32_t i, PathFate fate) const {
        io.fates[position(i)] = static_cast<std::uint8_t>(fate);
    }
};

template <PathOrder order, class T, class Offset>
struct ShadeTypeKernel {
    TypedMaterials<T> materials;
    SortedPaths<order> paths;

    CTP_INLINE void operator()(std::uint32_t i) const {
        paths.end(i, materials.template shade<Offset>(paths.io, paths.slot(i)));
    }
};

template <PathOrder order>
struct ShadeMissKernel {
    SortedPaths<order> paths;

    CTP_INLINE void operator()(std::uint32_t i) const { paths.end(i, shade_miss(paths.io, paths.slot(i))); }
};

template <PathOrder kOrder, class Types>
struct SortedShading {
    static constexpr PathOrder order = kOrder;
    using Layout = TypedMaterialArrays<Types>;
    using View = typename Layout::View;

    template <class Offset, class ForEach>
    static void shade(const View& view, const ShadeBuffers& io, const ShadeWork& work, ForEach&& for_each) {
        const auto launch = [&](std::uint32_t key, const auto& make) {
            const std::uint32_t first = work.key_offsets[key], count = work.key_offsets[key + 1] - first;
            if (count > 0) for_each(count, make(SortedPaths<order>{io, work.positions, first}));
        };
        for_each_type(Types{}, [&](auto tag) {
            using T = typename decltype(tag)::type;
            launch(index_of<T, Types>, [&](const SortedPaths<order>& paths) {
                return ShadeTypeKernel<order, T, Offset>{view.template of<T>(), paths};
            });
        });
        launch(io.words.miss_key(),
               [](const SortedPaths<order>& paths) { return ShadeMissKernel<order>{paths}; });
    }
};

template <class Types>
struct ShadeSort : SortedShading<PathOrder::sorted, Types> {
    static constexpr const char* name = "sort";
};

template <class Types>
struct ShadeSortRestored : SortedShading<PathOrder::restored, Types> {
    static constexpr const char* name = "sort_restored";
};

}  // namespace ctpbench
