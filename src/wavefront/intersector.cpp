// The explicit instantiations of every intersect strategy with every bundle of methods, on CPU threads.
#include "wavefront/intersector.h"

#include "kernels/registry.h"

namespace ctpbench {
namespace {

template <class Strategy>
class CpuIntersector final : public Intersector {
public:
    explicit CpuIntersector(const LayoutInput& input) : layout_(input) {}

    void intersect(CpuBackend& backend, const IntersectBuffers& io, bool carry_t) const override {
        Strategy::intersect(
            layout_.view(HostPlace{}), io, carry_t, [&](std::uint32_t count, const auto& kernel) {
                if (io.segment_counts == nullptr)
                    backend.for_each(count, kernel);
                else
                    backend.for_each_in_segments(io.segments, kSegment, io.segment_counts, kernel);
            });
    }
    std::size_t bytes() const override { return layout_.bytes(); }

private:
    typename Strategy::Layout layout_;
};

}  // namespace

std::vector<StrategyInfo> intersect_strategies() {
    std::vector<StrategyInfo> all;
    for_each_type(IntersectStrategies<Watertight>{}, [&](auto tag) {
        using Strategy = typename decltype(tag)::type;
        all.push_back({Strategy::name, Strategy::tree});
    });
    return all;
}

std::vector<MethodsInfo> method_bundles() {
    std::vector<MethodsInfo> all;
    for_each_type(MethodBundles{}, [&](auto tag) {
        using Methods = typename decltype(tag)::type;
        all.push_back({Methods::name, Methods::exact});
    });
    return all;
}

std::unique_ptr<Intersector> make_intersector(std::string_view strategy, std::string_view methods,
                                              const LayoutInput& input) {
    std::unique_ptr<Intersector> made;
    for_each_type(MethodBundles{}, [&](auto bundle) {
        using Methods = typename decltype(bundle)::type;
        if (methods != Methods::name) return;
        for_each_type(IntersectStrategies<Methods>{}, [&](auto tag) {
            using Strategy = typename decltype(tag)::type;
            if (strategy == Strategy::name) made = std::make_unique<CpuIntersector<Strategy>>(input);
        });
    });
    if (!made) trap();
    return made;
}

}  // namespace ctpbench
