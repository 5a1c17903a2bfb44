#include "render.h"

#include <cstdio>

#include "base/interrupt.h"
#include "report/image.h"
#include "report/progress.h"
#include "scene/load_scene.h"
#include "wavefront/forest.h"
#include "wavefront/renderer.h"
#include "wavefront/typed_scenes.h"

namespace ctpbench {
namespace {

Scene load(const CommandLine& line) {
    SceneRequest request;
    request.name = line.scene;
    request.choice = line.scenes;
    request.scene_dirs = line.scene_dirs;
    if (line.spheres > 0) request.spheres = line.spheres;
    request.seed = line.seed;
    Notices notices;
    Scene scene = load_scene(request, notices);
    if (!line.quiet) {
        for (const std::string& n : notices) std::fprintf(stderr, "%s\n", n.c_str());
        std::printf("%s: %zu triangles (%s), %zu spheres, %zu materials\n", scene.name.c_str(),
                    scene.mesh.triangles.size(), scene.source == SceneSource::mesh ? "mesh" : "stand-in",
                    scene.spheres.size(), scene.materials.size());
    }
    return scene;
}

}  // namespace

ExitCode render(const CommandLine& line) {
    require_image_output(line.image);
    const Scene scene = load(line);
    CpuBackend backend(static_cast<int>(line.threads.value_or(0)));
    Progress progress(line.quiet);
    progress.start_workload(0, 1, scene.name);
    progress.step("building the tree", 0.0);
    const Forest forest = build_forest(backend, scene, {TreeKind::typed_leaves}, SbvhSettings::quality(),
                                       nullptr, [](const std::string&, double) {});
    const SceneView view(scene);
    const auto intersector =
        make_intersector("typed_leaves", "watertight", forest.layout_input(view.geometry()));
    const MaterialTable materials(scene,
                                  material_types(kTypesOfScene, WaechterBinder::name, needs_of(scene)));
    const auto shader = make_shader("ctp", materials);
    Renderer renderer(backend, view, scene.camera,
                      {line.width, line.height, line.bounces, line.seed.value_or(1)});
    ImageStorage image;
    std::uint32_t done = 0;
    while (done < line.samples && !interrupted()) {
        renderer.frame(*intersector, *shader, true, done, image, {});
        ++done;
        if (done % 16 == 0 || done == line.samples)
            progress.step(std::to_string(done) + " of " + std::to_string(line.samples) + " samples",
                          static_cast<double>(done) / line.samples);
    }
    if (done > 0)
        write_image(line.image, line.width, line.height, image, line.exposure.value_or(scene.exposure));
    if (done == line.samples) return ExitCode::ok;
    progress.note("interrupted: the image holds " + std::to_string(done) + " samples per pixel");
    return ExitCode::interrupted;
}

}  // namespace ctpbench
