#include "oracle/embree_scene.h"

#include <algorithm>
#include <string>

#include "base/clock.h"
#include "base/error.h"
#include "oracle/embree_api.h"

namespace ctpbench {

#ifdef CTPBENCH_EMBREE

namespace {

void attach(RTCScene scene, RTCGeometry geometry, unsigned id) {
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, id);
    rtcReleaseGeometry(geometry);
}

void attach_triangles(RTCDevice device, RTCScene scene, const Mesh& mesh) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                             sizeof(Vec3), mesh.positions.size());
    void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            sizeof(mesh.triangles[0]), mesh.triangles.size());
    std::copy(mesh.positions.begin(), mesh.positions.end(), static_cast<Vec3*>(vertices));
    std::copy(mesh.triangles.begin(), mesh.triangles.end(),
              static_cast<std::array<std::uint32_t, 3>*>(indices));
    attach(scene, geometry, 0);
}

void attach_spheres(RTCDevice device, RTCScene scene, const std::vector<SphereShape>& spheres) {
    static_assert(sizeof(SphereShape) == 16);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    void* points = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                           sizeof(SphereShape), spheres.size());
    std::copy(spheres.begin(), spheres.end(), static_cast<SphereShape*>(points));
    attach(scene, geometry, 1);
}

}  // namespace

EmbreeScene::EmbreeScene(const Scene& scene, EmbreeMode mode, int threads)
    : first_sphere_(static_cast<std::uint32_t>(scene.mesh.triangles.size())) {
    build_seconds_ = seconds_of([&] {
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
        if (!scene.mesh.triangles.empty()) attach_triangles(device_, scene_, scene.mesh);
        if (!scene.spheres.empty()) attach_spheres(device_, scene_, scene.spheres);
        rtcCommitScene(scene_);
    });
    const RTCError error = rtcGetDeviceError(device_);
    if (error == RTC_ERROR_NONE) return;
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
    throw Error(ExitCode::internal, "Embree could not build its tree (error " + std::to_string(error) +
                                        "; 4 means out of memory)");
}

EmbreeScene::~EmbreeScene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
}

#else

EmbreeScene::EmbreeScene(const Scene&, EmbreeMode, int) {
    throw Error(ExitCode::no_backend,
                "this program was built without Embree: install libembree-dev and build again");
}

EmbreeScene::~EmbreeScene() = default;

#endif

}  // namespace ctpbench
