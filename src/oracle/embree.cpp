#include "oracle/embree.h"

#include <utility>

#include "kernels/platform.h"
#include "oracle/embree_api.h"
#include "oracle/embree_kernels.h"

namespace ctpbench {

std::vector<EmbreeContender> embree_contenders() {
    using enum EmbreeMode;
    using enum EmbreeCall;
    return {{"embree_robust", robust, one, false},
            {"embree_default", fast, one, false},
            {"embree_16", fast, packet, false},
            {"embree_16_robust", robust, packet, false},
            {"embree_16_coherent", fast, packet, true},
            {"embree_16_coherent_robust", robust, packet, true},
            {"embree_stream", fast, stream, false},
            {"embree_stream_robust", robust, stream, false},
            {"embree_stream_coherent", fast, stream, true},
            {"embree_stream_coherent_robust", robust, stream, true}};
}

std::string embree_obstacle(const std::string& name) {
    for (const EmbreeContender& e : embree_contenders()) {
        if (e.name != name) continue;
        if (embree_version().empty()) return "this program was built without Embree";
#if defined(CTPBENCH_EMBREE) && CTPBENCH_EMBREE != 3
        if (e.call == EmbreeCall::stream)
            return "Embree " + embree_version() + " has no streams of rays; build with Embree 3";
#endif
    }
    return {};
}

std::unique_ptr<Intersector> make_embree(const Scene& scene, EmbreeMode mode, int threads) {
    return make_embree(std::make_shared<const EmbreeScene>(scene, mode, threads), EmbreeCall::one);
}

#ifdef CTPBENCH_EMBREE

std::string embree_version() { return RTC_VERSION_STRING; }

namespace {

constexpr std::uint32_t kChunk = 1024;  // rays that a thread takes at a time

template <class Kernel>
class EmbreeIntersector final : public Intersector {
public:
    EmbreeIntersector(std::shared_ptr<const EmbreeScene> scene, bool coherent)
        : scene_(std::move(scene)), coherent_(coherent) {}

    void intersect(CpuBackend& backend, const IntersectBuffers& io, bool) const override {
        const Kernel kernel{{scene_->handle(), io, scene_->first_sphere(), coherent_}};
        backend.for_each((io.count + Kernel::rays - 1) / Kernel::rays, kernel, kChunk / Kernel::rays);
    }
    std::size_t bytes() const override { return scene_->bytes(); }

private:
    std::shared_ptr<const EmbreeScene> scene_;
    bool coherent_;
};

}  // namespace

std::unique_ptr<Intersector> make_embree(std::shared_ptr<const EmbreeScene> scene, EmbreeCall call,
                                         bool coherent) {
    if (call == EmbreeCall::one)
        return std::make_unique<EmbreeIntersector<EmbreeOneKernel>>(std::move(scene), coherent);
    if (call == EmbreeCall::packet)
        return std::make_unique<EmbreeIntersector<EmbreePacketKernel>>(std::move(scene), coherent);
#if CTPBENCH_EMBREE == 3
    return std::make_unique<EmbreeIntersector<EmbreeStreamKernel>>(std::move(scene), coherent);
#else
    trap();
#endif
}

#else

std::string embree_version() { return {}; }

std::unique_ptr<Intersector> make_embree(std::shared_ptr<const EmbreeScene>, EmbreeCall, bool) { trap(); }

#endif

}  // namespace ctpbench
