#include "scene/load_scene.h"

#include "base/error.h"
#include "kernels/materials/list.h"
#include "scene/content_hash.h"
#include "scene/find_scene.h"
#include "scene/framing.h"
#include "scene/material_library.h"
#include "scene/mesh_cache.h"
#include "scene/recipes/recipes.h"
#include "scene/spheres.h"
#include "scene/textures.h"
#include "scene/trim.h"

namespace ctpbench {
namespace {

namespace fs = std::filesystem;

void notice_dropped(const DroppedTriangles& dropped, const fs::path& path, Notices& notices) {
    if (dropped.total() == 0) return;
    notices.push_back(path.string() + ":" + std::to_string(dropped.first_line) +
                      ": the first of the dropped triangles: " + std::to_string(dropped.zero_area) +
                      " without area, " + std::to_string(dropped.bad_vertex) +
                      " with a coordinate that is NaN, infinite or beyond 1e18");
}

void notice_bad_texcoords(const BadTexcoords& bad, const fs::path& path, Notices& notices) {
    if (bad.count == 0) return;
    notices.push_back(
        path.string() + ":" + std::to_string(bad.first_line) + ": the first of " + std::to_string(bad.count) +
        " texture coordinates that are NaN, infinite, beyond 1e18 or no numbers; they count as 0, 0");
}

// The paper states thousands.
void notice_count(const SceneFile& file, const MeshEdition& edition, std::uint64_t triangles,
                  Notices& notices) {
    const std::string counted = "scene \"" + file.name + "\": " + std::to_string(triangles) + " triangles";
    if (edition.triangles != 0 && edition.triangles != triangles) {
        notices.push_back(counted + ", but the scene file expects " + std::to_string(edition.triangles) +
                          "; it is another edition of the mesh, or incomplete");
    }
    const auto thousands = [](std::uint64_t count) { return (count + 500) / 1000; };
    if (file.paper_triangles != 0 && thousands(file.paper_triangles) != thousands(triangles)) {
        notices.push_back(counted + ", but the paper's mesh has " +
                          std::to_string(thousands(file.paper_triangles)) + "K" +
                          (edition.variant.empty() ? "" : ": " + edition.variant));
    }
}

void add_mesh(Scene& scene, const SceneFile& file, const FoundMesh& found, Notices& notices) {
    ObjMesh obj = load_obj(found.path, mesh_cache_folder(), notices);
    scene.source = SceneSource::mesh;
    MeshMaterials library = read_materials(obj, found.path, notices);
    scene.materials = std::move(library.materials);
    scene.mesh = std::move(obj.mesh);
    scene.dropped_triangles = obj.dropped.total();
    notice_dropped(obj.dropped, found.path, notices);
    notice_bad_texcoords(obj.bad_texcoords, found.path, notices);
    notice_count(file, *found.edition, scene.mesh.triangles.size() + scene.dropped_triangles, notices);
    const std::optional<Camera>& camera = found.edition->camera ? found.edition->camera : file.camera;
    scene.camera = camera ? *camera : framing_camera(scene_bounds(scene));
    // An override may make a material of a type that has no texture, which then need not be read.
    apply_overrides(file.overrides, scene.materials);
    apply_overrides(found.edition->overrides, scene.materials);
    load_textures(scene, library.textures, notices);
}

void add_recipe(Scene& scene, const SceneFile& file) {
    scene.source = SceneSource::stand_in;
    const RecipeChoice& choice = *file.recipe;
    find_recipe(choice.name)->build(scene.mesh, scene.materials, choice.seed, choice.triangles);
    for (Vec3& position : scene.mesh.positions) position = position + choice.origin;
    scene.camera = file.camera ? *file.camera : framing_camera(scene_bounds(scene));
    apply_overrides(file.overrides, scene.materials);
}

// Mesh or recipe of this very file, without a look at its stand-in. This and the next two return the spheres
// to place, which stay apart since the scattered ones fill the bounds of the triangles alone.
std::vector<SphereShape> add_geometry(Scene& scene, const SceneFile& file, const Folders& folders,
                                      Notices& notices) {
    if (file.recipe) {
        add_recipe(scene, file);
    } else if (const auto found = find_mesh(file, folders)) {
        add_mesh(scene, file, *found, notices);
    } else {
        fail_without_mesh(file, folders);
    }
    scene.ambient = file.ambient;
    scene.exposure = file.exposure;
    return file.spheres.placed;
}

std::vector<SphereShape> add_stand_in(Scene& scene, const SceneFile& file, const Folders& folders,
                                      Notices& notices) {
    auto placed =
        add_geometry(scene, read_scene_file(find_scene_file(file.stand_in, folders)), folders, notices);
    scene.source = SceneSource::stand_in;
    return placed;
}

std::vector<SphereShape> add_chosen_geometry(Scene& scene, const SceneFile& file, SceneChoice choice,
                                             const Folders& folders, Notices& notices) {
    if (!takes_stand_in(file, choice, folders)) return add_geometry(scene, file, folders, notices);
    if (choice == SceneChoice::auto_)
        notices.push_back(
            "scene \"" + file.name + "\": its mesh was not found, so the stand-in \"" + file.stand_in +
            "\" takes its place; its figures do not compare with the paper's. scripts/fetch_scenes "
            "downloads the mesh");
    return add_stand_in(scene, file, folders, notices);
}

void add_spheres(Scene& scene, std::vector<SphereShape> placed, const SphereSettings& settings,
                 const SceneRequest& request) {
    const auto scattered = scatter_spheres(scene_bounds(scene), request.spheres.value_or(settings.count),
                                           request.sphere_radius.value_or(settings.radius),
                                           request.seed.value_or(settings.seed));
    scene.spheres = std::move(placed);
    scene.spheres.insert(scene.spheres.end(), scattered.begin(), scattered.end());
    if (scene.spheres.empty()) return;
    scene.sphere_material = static_cast<std::uint32_t>(scene.materials.size());
    Material& material = scene.materials.emplace_back();
    material.name = "spheres";
    material.look.type = material_type<Mirror>;
    material.look.specular = settings.specular;
}

}  // namespace

Scene load_scene(const SceneRequest& request, Notices& notices) {
    Folders folders = scene_search_path(request.scene_dirs);
    const SceneFile file = find_and_read(request.name, folders);
    Scene scene;
    scene.name = request.name;
    auto placed = add_chosen_geometry(scene, file, request.choice, folders, notices);
    add_spheres(scene, std::move(placed), file.spheres, request);
    trim(scene);
    scene.content_hash = content_hash(scene);
    return scene;
}

}  // namespace ctpbench
