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

template <PathOrder kOrder>
struct SortedShading {
    static constexpr PathOrder order = kOrder;
    using Layout = TypedMaterialArrays;
    using View = TypedMaterialArrays::View;

    // The paths of one key, in sorted order.
    struct Range {
        ShadeBuffers io;
        const std::uint32_t* positions;
        std::uint32_t first;

        CTP_INLINE std::uint32_t position(std::uint32_t i) const {
            return kOrder == PathOrder::restored ? positions[first + i] : first + i;
        }
        CTP_INLINE std::uint32_t slot(std::uint32_t i) const { return io.index[position(i)]; }
        CTP_INLINE void end(std::uint32_t i, PathFate fate) const {
            io.fates[position(i)] = static_cast<std::uint8_t>(fate);
        }
    };

    template <class T, class Offset>
    struct Kernel {
        TypedMaterials<T> materials;
        Range range;

        CTP_HD void operator()(std::uint32_t i) const {
            range.end(i, materials.template shade<Offset>(range.io, range.slot(i)));
        }
    };

    struct MissKernel {
        Range range;

        CTP_HD void operator()(std::uint32_t i) const { range.end(i, shade_miss(range.io, range.slot(i))); }
    };

    template <class Offset, class ForEach>
    static void shade(const View& view, const ShadeBuffers& io, const ShadeWork& work, ForEach&& for_each) {
        const auto launch = [&](std::uint32_t key, const auto& make) {
            const std::uint32_t first = work.key_offsets[key], count = work.key_offsets[key + 1] - first;
            if (count > 0) for_each(count, make(Range{io, work.positions, first}));
        };
        for_each_type(Materials{}, [&](auto tag) {
            using T = typename decltype(tag)::type;
            launch(material_type<T>, [&](const Range& range) {
                return Kernel<T, Offset>{view.template of<T>(), range};
            });
        });
        launch(kMissKey, [](const Range& range) { return MissKernel{range}; });
    }
};

struct ShadeSort : SortedShading<PathOrder::sorted> {
    static constexpr const char* name = "sort";
};

struct ShadeSortRestored : SortedShading<PathOrder::restored> {
    static constexpr const char* name = "sort_restored";
};

}  // namespace ctpbench
