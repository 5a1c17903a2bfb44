#include "picture.h"

#include <cmath>
#include <vector>

#include "base/error.h"
#include "report/image.h"
#include "wavefront/forest.h"
#include "wavefront/paths.h"

namespace ctpbench {
namespace {

// Turns the camera rays into rays that look for what is near, and keeps what the eye's light gives.
struct EyeLightKernel {
    GeometryView geometry;
    MaterialView materials;
    RayColumns rays;
    HitColumns hits;
    std::uint64_t seed;
    std::uint32_t sample;
    float reach;
    Vec3* color;

    void operator()(std::uint32_t i) const {
        const Hit hit = hits.load(i);
        const Ray ray = rays.load(i);
        if (hit.primitive == kNoPrimitive) {
            color[i] = {0.55f, 0.70f, 0.90f};
            rays.store(i, {ray.origin, ray.direction, 0.0f});  // reaches nothing
            return;
        }
        const Surface s = surface_at(geometry, ray, hit);
        const Vec3 albedo =
            materials.albedo[hit.primitive < geometry.first_sphere() ? materials.material[hit.primitive]
                                                                     : materials.sphere_material];
        color[i] = albedo * (0.3f + 0.7f * absolute(dot(s.normal, ray.direction)));
        const Random4 r = random4(seed, i, sample, 0, Dimension::direction);
        rays.store(i, {offset_origin(s.point, s.normal), cosine_direction(s.normal, r.v[0], r.v[1]), reach});
    }
};

struct AccumulateKernel {
    HitColumns hits;
    const Vec3* color;
    Vec3* sum;

    void operator()(std::uint32_t i) const {
        constexpr float occluded = 0.35f;
        sum[i] = sum[i] + color[i] * (hits.primitive[i] == kNoPrimitive ? 1.0f : occluded);
    }
};

float encode_srgb(float linear) {
    const float x = min(max(linear, 0.0f), 1.0f);
    return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
}

}  // namespace

void draw_scene(CpuBackend& backend, const Scene& scene, const PictureSettings& settings,
                const std::filesystem::path& image) {
    require_image_output(image);
    const Forest forest = build_forest(backend, scene, {TreeKind::typed_leaves}, SbvhSettings::paper(),
                                       nullptr, [](const std::string&, double) {});
    const SceneView view(scene);
    const auto tracer = make_intersector("typed_leaves", "watertight", forest.layout_input(view.geometry()));

    const std::uint32_t pixels = settings.width * settings.height;
    RayStorage rays;
    HitStorage hits;
    PixelStorage columns;
    rays.resize(pixels), hits.resize(pixels), columns.resize(pixels);
    std::vector<std::uint32_t> index(pixels);
    std::vector<Vec3> color(pixels), sum(pixels, Vec3{0, 0, 0});
    const CameraFrame frame = camera_frame(scene.camera.eye, scene.camera.target, scene.camera.up,
                                           scene.camera.fov_degrees, settings.width, settings.height);
    const float reach = 0.06f * length(scene_bounds(scene).extent());
    for (std::uint32_t sample = 0; sample < settings.samples; ++sample) {
        backend.for_each(pixels, GenerateKernel{frame, settings.width, settings.height, settings.seed, sample,
                                                rays.view(), columns.view(), index.data()});
        const IntersectBuffers io{rays.view(), hits.view(), index.data(), pixels, view.geometry().extent};
        tracer->intersect(backend, io, true);
        backend.for_each(pixels, EyeLightKernel{view.geometry(), view.materials(), rays.view(), hits.view(),
                                                settings.seed, sample, reach, color.data()});
        tracer->intersect(backend, io, true);
        backend.for_each(pixels, AccumulateKernel{hits.view(), color.data(), sum.data()});
    }
    std::vector<float> rgb(std::size_t{pixels} * 3);
    for (std::uint32_t i = 0; i < pixels; ++i)
        for (int c = 0; c < 3; ++c)
            rgb[std::size_t{i} * 3 + static_cast<std::size_t>(c)] =
                encode_srgb(sum[i][c] / static_cast<float>(settings.samples));
    write_image(image, settings.width, settings.height, rgb);
}

}  // namespace ctpbench
