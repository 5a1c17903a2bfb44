#include "scene/scene_file.h"

#include "base/json_reader.h"
#include "scene/recipes/recipes.h"

namespace ctpbench {
namespace {

Camera read_camera(const JsonObject& json) {
    Camera camera;
    const bool has_eye = json.require("eye", camera.eye), has_target = json.require("target", camera.target);
    json.get("up", camera.up);
    json.get("fov", camera.fov_degrees, range(1, 179));
    if (!has_eye || !has_target) return camera;  // said already
    if (length(cross(camera.target - camera.eye, camera.up)) > 0.0f) return camera;
    json.error("the camera's \"up\" must not be zero or along its view, and \"eye\" not at \"target\"");
    return camera;
}

std::optional<Camera> read_camera_if_there(const JsonObject& parent) {
    if (!parent.has("camera")) return std::nullopt;
    return read_camera(parent.object("camera"));
}

MeshEdition read_edition(const JsonObject& json, const JsonDocument& document) {
    MeshEdition edition;
    for (const JsonValue& value : json.value("file").list_or_one()) {
        std::string file;
        if (value.read(file)) edition.files.push_back(file);
    }
    if (edition.files.empty()) json.error("a mesh needs a \"file\"");
    json.get("triangles", edition.triangles);
    json.get("variant", edition.variant);
    edition.camera = read_camera_if_there(json);
    edition.overrides = read_overrides(json.object("overrides"), document);
    return edition;
}

void read_geometry(const JsonObject& root, const JsonDocument& document, SceneFile& scene) {
    if (root.has("mesh") == root.has("recipe")) root.error("a scene needs either \"mesh\" or \"recipe\"");
    for (const JsonValue& value : root.value("mesh").list_or_one()) {
        scene.meshes.push_back(read_edition(value.object(), document));
    }
    if (root.has("mesh") && scene.meshes.empty())
        root.error("mesh", "an empty list; a mesh needs a \"file\"");
    if (!root.has("recipe")) return;
    std::vector<std::string> names;
    for (const Recipe& recipe : recipes()) names.emplace_back(recipe.name);
    const JsonObject json = root.object("recipe");
    scene.recipe.emplace();
    json.require("name", scene.recipe->name, names);
    json.get("seed", scene.recipe->seed);
    json.get("origin", scene.recipe->origin);
    const Recipe* recipe = find_recipe(scene.recipe->name);
    if (recipe == nullptr) return;  // said above
    scene.recipe->triangles = recipe->triangles;
    if (recipe->least < recipe->triangles)
        json.get("triangles", scene.recipe->triangles, range(recipe->least, kMostTriangles));
    else if (json.has("triangles"))
        json.error("triangles", scene.recipe->name + " comes in one size; leave this out");
}

void read_spheres(const JsonObject& json, SphereSettings& spheres) {
    json.get("count", spheres.count, range(0, 1e9));
    json.get("radius", spheres.radius, above(0));
    json.get("seed", spheres.seed);
    json.get("specular", spheres.specular, range(0, 1));
    for (const JsonValue& value : json.list("placed")) {
        const JsonObject sphere = value.object();
        SphereShape& shape = spheres.placed.emplace_back();
        sphere.require("center", shape.center);
        sphere.require("radius", shape.radius, above(0));
    }
}

}  // namespace

SceneFile read_scene_file(const std::filesystem::path& path) {
    JsonReader reader(JsonDocument::load(path));
    const JsonObject root = reader.root();
    SceneFile scene;
    scene.path = path;
    std::uint32_t schema_version = 1;
    root.require("schema_version", schema_version, range(1, 1));
    root.require("name", scene.name);
    read_geometry(root, reader.document(), scene);
    root.get("stand_in", scene.stand_in);
    root.get("paper_triangles", scene.paper_triangles);
    scene.camera = read_camera_if_there(root);
    root.get("ambient", scene.ambient, at_least(0));
    root.get("exposure", scene.exposure, above(0));
    read_spheres(root.object("spheres"), scene.spheres);
    scene.overrides = read_overrides(root.object("overrides"), reader.document());
    reader.finish();
    return scene;
}

}  // namespace ctpbench
