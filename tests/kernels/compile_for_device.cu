// Instantiates the kernels' functors in device code: the headers are single source, and this keeps them so
// on machines without a GPU. Compiled by scripts/check_headers where there is an nvcc; never run.
#include "kernels/blend.h"
#include "kernels/compact.h"
#include "kernels/generate.h"
#include "kernels/methods/exchanges.h"
#include "kernels/registry.h"
#include "kernels/sort.h"

namespace ctpbench {

template <class Kernel>
__global__ void run(Kernel kernel, std::uint32_t count) {
    const std::uint32_t i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < count) kernel(i);
}

template <class Methods>
void launch_strategies(const LayoutInput& input, const IntersectBuffers& io) {
    const auto launch = [](std::uint32_t count, const auto& kernel) { run<<<1, 1>>>(kernel, count); };
    const HostPlace place;
    for_each_type(IntersectStrategies<Methods>{}, [&](auto tag) {
        using Strategy = typename decltype(tag)::type;
        Strategy::intersect(typename Strategy::Layout(input).view(place), io, true, launch);
    });
}

template <class Strategy>
void launch_shade(const MaterialInput& materials, const ShadeBuffers& io, const ShadeWork& work) {
    const typename Strategy::Layout layout(materials);
    const auto launch = [](std::uint32_t count, const auto& kernel, auto...) {
        run<<<1, 1>>>(kernel, count);
    };
    for_each_type(Offsets{}, [&](auto tag) {
        Strategy::template shade<typename decltype(tag)::type>(layout.view(HostPlace{}), io, work, launch);
    });
}

void instantiate(const MaterialInput& materials, const ShadeBuffers& shading, const ShadeWork& work) {
    for_each_type(ShadeStrategies<Materials>{},
                  [&](auto tag) { launch_shade<typename decltype(tag)::type>(materials, shading, work); });
}

void instantiate(const LayoutInput& input, const IntersectBuffers& io) {
    for_each_type(MethodBundles{},
                  [&](auto tag) { launch_strategies<typename decltype(tag)::type>(input, io); });
    const auto launch_ctp = [&](auto tag) {
        using Methods = typename decltype(tag)::type;
        const typename Ctp<Methods>::Layout layout(input);
        Ctp<Methods>::intersect(
            layout.view(HostPlace{}), io, true,
            [](std::uint32_t count, const auto& kernel) { run<<<1, 1>>>(kernel, count); });
    };
    for_each_type(TriangleTests{}, [&](auto tag) {
        for_each_type(TestsWithTriangle<typename decltype(tag)::type>{}, launch_ctp);
    });
    for_each_type(TestsWithSpheres{}, launch_ctp);
    launch_ctp(TypeTag<ExcludingTests>{});
    run<<<1, 1>>>(GenerateKernel{}, 1);
    run<<<1, 1>>>(BlendKernel{}, 1);
    run<<<1, 1>>>(CompactCountKernel{}, 1);
    run<<<1, 1>>>(CompactScatterKernel{}, 1);
    run<<<1, 1>>>(SortCountKernel{}, 1);
    run<<<1, 1>>>(SortScatterKernel<2>{}, 1);
    run<<<1, 1>>>(SortScatterManyKernel{}, 1);
}

}  // namespace ctpbench
