#include "oracle/embree.h"

#include <algorithm>
#include <atomic>
#include <chrono>

#include "base/error.h"

#if CTPBENCH_EMBREE == 4
#include <embree4/rtcore.h>
#elif CTPBENCH_EMBREE == 3
#include <embree3/rtcore.h>
#endif

namespace ctpbench {

std::vector<EmbreeContender> embree_contenders() {
    return {{"embree_robust", EmbreeMode::robust}, {"embree_default", EmbreeMode::fast}};
}

#ifdef CTPBENCH_EMBREE

std::string embree_version() { return RTC_VERSION_STRING; }

namespace {

struct IntersectOneKernel {
    RTCScene scene;
    IntersectBuffers io;
    std::uint32_t first_sphere;

    void operator()(std::uint32_t i) const {
        const std::uint32_t slot = io.index[i];
        const Ray ray = io.rays.load(slot);
        RTCRayHit rh;
        rh.ray.org_x = ray.origin.x, rh.ray.org_y = ray.origin.y, rh.ray.org_z = ray.origin.z;
        rh.ray.dir_x = ray.direction.x, rh.ray.dir_y = ray.direction.y, rh.ray.dir_z = ray.direction.z;
        rh.ray.tnear = 0.0f, rh.ray.tfar = ray.tmax;
        rh.ray.time = 0.0f, rh.ray.mask = 0xffffffffu, rh.ray.id = 0, rh.ray.flags = 0;
        rh.hit.geomID = rh.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        rh.hit.primID = kNoPrimitive;
#if CTPBENCH_EMBREE == 4
        rtcIntersect1(scene, &rh);
#else
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(scene, &context, &rh);
#endif
        if (rh.hit.geomID == RTC_INVALID_GEOMETRY_ID)
            io.hits.store(slot, no_hit(ray));
        else if (rh.hit.geomID == 0)
            io.hits.store(slot, {rh.ray.tfar, rh.hit.primID, rh.hit.u, rh.hit.v});
        else
            io.hits.store(slot, {rh.ray.tfar, first_sphere + rh.hit.primID, 0.0f, 0.0f});
    }
};

// Geometry 0 holds the triangles, geometry 1 the spheres; either may be absent.
class EmbreeScene final : public EmbreeIntersector {
public:
    EmbreeScene(const Scene& scene, EmbreeMode mode, int threads)
        : first_sphere_(static_cast<std::uint32_t>(scene.mesh.triangles.size())) {
        const auto start = std::chrono::steady_clock::now();
        device_ = rtcNewDevice(("threads=" + std::to_string(threads)).c_str());
        if (device_ == nullptr)
            throw Error(ExitCode::internal, "Embree could not create a device (error " +
                                                std::to_string(rtcGetDeviceError(nullptr)) + ")");
        rtcSetDeviceMemoryMonitorFunction(
            device_,
            [](void* self, ssize_t bytes, bool) {
                static_cast<EmbreeScene*>(self)->bytes_ += bytes;
                return true;
            },
            this);
        scene_ = rtcNewScene(device_);
        rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
        rtcSetSceneFlags(scene_, mode == EmbreeMode::robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
        if (!scene.mesh.triangles.empty()) attach_triangles(scene.mesh);
        if (!scene.spheres.empty()) attach_spheres(scene.spheres);
        rtcCommitScene(scene_);
        const RTCError error = rtcGetDeviceError(device_);
        if (error != RTC_ERROR_NONE) {
            release();
            throw Error(ExitCode::internal, "Embree could not build its tree (error " +
                                                std::to_string(error) + "; 4 means out of memory)");
        }
        build_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    ~EmbreeScene() override { release(); }

    void intersect(CpuBackend& backend, const IntersectBuffers& io, bool) const override {
        backend.for_each(io.count, IntersectOneKernel{scene_, io, first_sphere_});
    }
    std::size_t bytes() const override { return static_cast<std::size_t>(bytes_.load()); }

private:
    void release() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    void attach_triangles(const Mesh& mesh) {
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                 sizeof(Vec3), mesh.positions.size());
        void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                sizeof(mesh.triangles[0]), mesh.triangles.size());
        std::copy(mesh.positions.begin(), mesh.positions.end(), static_cast<Vec3*>(vertices));
        std::copy(mesh.triangles.begin(), mesh.triangles.end(),
                  static_cast<std::array<std::uint32_t, 3>*>(indices));
        commit(geometry, 0);
    }
    void attach_spheres(const std::vector<SphereShape>& spheres) {
        static_assert(sizeof(SphereShape) == 16);
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
        void* points = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                               sizeof(SphereShape), spheres.size());
        std::copy(spheres.begin(), spheres.end(), static_cast<SphereShape*>(points));
        commit(geometry, 1);
    }
    void commit(RTCGeometry geometry, unsigned id) {
        rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(scene_, geometry, id);
        rtcReleaseGeometry(geometry);
    }

    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;
    std::uint32_t first_sphere_;
    std::atomic<ssize_t> bytes_{0};
};

}  // namespace

std::unique_ptr<EmbreeIntersector> make_embree(const Scene& scene, EmbreeMode mode, int threads) {
    return std::make_unique<EmbreeScene>(scene, mode, threads);
}

#else

std::string embree_version() { return {}; }

std::unique_ptr<EmbreeIntersector> make_embree(const Scene&, EmbreeMode, int) {
    throw Error(ExitCode::no_backend,
                "this program was built without Embree: install libembree-dev and build again");
}

#endif

}  // namespace ctpbench
