#include "scene/obj_mesh.h"

#include <tiny_obj_loader.h>

#include <cmath>
#include <istream>
#include <limits>
#include <map>
#include <span>
#include <unordered_map>

#include "base/error.h"
#include "base/memory.h"
#include "scene/obj_text.h"
#include "scene/triangulate.h"

namespace ctpbench {
namespace {

constexpr float kLargestCoordinate = 1e18f;  // its square, and the products of a tree's areas, are finite
constexpr std::uint32_t kNoMaterial = 0xffffffffu;
// A polygon of so many is cut into triangles in a second at worst, and the time grows with their cube.
constexpr std::size_t kMostCorners = 2000;
constexpr std::size_t kMostLibraries = 1000;  // each is compared with all before it

bool usable(Vec3 p) {  // false for NaN too
    return absolute(p.x) <= kLargestCoordinate && absolute(p.y) <= kLargestCoordinate &&
           absolute(p.z) <= kLargestCoordinate;
}

// In float64: differences of float32 coordinates of like size are exact there, and so are their products.
bool has_area(Vec3 a, Vec3 b, Vec3 c) {
    const auto side = [](Vec3 from, Vec3 to, int axis) { return static_cast<double>(to[axis]) - from[axis]; };
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        if (side(a, b, u) * side(a, c, v) != side(a, b, v) * side(a, c, u)) return true;
    }
    return false;
}

// As push_back(), but refuses up front what would not fit into memory while the vector grows.
template <class T>
void append(std::vector<T>& to, const T& value, const std::string& file) {
    constexpr std::size_t kSmall = std::size_t{1} << 20;
    if (to.size() == to.capacity() && to.size() >= kSmall)
        require_memory(2.0 * static_cast<double>(to.size()) * sizeof(T), file, "use a smaller mesh");
    to.push_back(value);
}

// Keeps the names that an OBJ's mtllib lines give; the files are read later, by material_library.h.
class LibraryNames : public tinyobj::MaterialReader {
public:
    LibraryNames(ObjText& text, std::vector<ObjName>& names, const std::string& file)
        : text_(text), names_(names), file_(file) {}
    bool operator()(const std::string& name, std::vector<tinyobj::material_t>*, std::map<std::string, int>*,
                    std::string*, std::string*) override {
        for (const ObjName& known : names_) {
            if (known.name == name) return false;
        }
        if (names_.size() == kMostLibraries)
            throw Error(ExitCode::usage, file_ + ":" + std::to_string(text_.line_number()) +
                                             ": error: names more than " + std::to_string(kMostLibraries) +
                                             " material libraries; join them");
        names_.push_back({name, text_.line_number()});
        return false;  // "not read": tinyobjloader then goes on to the line's next name
    }

private:
    ObjText& text_;
    std::vector<ObjName>& names_;
    const std::string& file_;
};

class ObjParser {
public:
    ObjParser(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    ObjMesh parse() {
        tinyobj::callback_t callbacks;
        callbacks.vertex_cb = [](void* self, float, float, float, float) {
            static_cast<ObjParser*>(self)->add_vertex();
        };
        callbacks.texcoord_cb = [](void* self, float, float, float) {
            static_cast<ObjParser*>(self)->add_texcoord();
        };
        callbacks.index_cb = [](void* self, tinyobj::index_t* indices, int count) {
            static_cast<ObjParser*>(self)->add_face({indices, static_cast<std::size_t>(count)});
        };
        callbacks.usemtl_cb = [](void* self, const char* name, int) {
            static_cast<ObjParser*>(self)->use_material(name);
        };
        std::istream stream(&text_);
        LibraryNames libraries(text_, out_.libraries, file_);
        tinyobj::LoadObjWithCallback(stream, callbacks, this, &libraries);
        if (!out_.mesh.texcoords.empty()) out_.mesh.texcoords.resize(out_.mesh.triangles.size());
        return std::move(out_);
    }

private:
    [[noreturn]] void fail(const std::string& problem) {
        throw Error(ExitCode::usage, file_ + ":" + std::to_string(text_.line_number()) + ": " + problem +
                                         " (\"" + std::string(text_.line().substr(0, 80)) + "\")");
    }

    // tinyobjloader has read the coordinates already, but turns what is no number into 0 without a word.
    void add_vertex() {
        const std::optional<Vec3> vertex = parse_vertex(text_.line());
        if (!vertex) fail("a vertex needs three numbers");
        if (out_.mesh.positions.size() == std::numeric_limits<std::int32_t>::max()) fail("too many vertices");
        append(out_.mesh.positions, *vertex, file_);
    }

    void add_texcoord() {
        std::optional<Vec2> uv = parse_texcoord(text_.line());
        if (!uv || !usable({uv->x, uv->y, 0.0f})) {
            BadTexcoords& bad = out_.bad_texcoords;
            if (bad.count++ == 0) bad.first_line = text_.line_number();
            uv = Vec2{0.0f, 0.0f};
        }
        if (texcoords_.size() == std::numeric_limits<std::int32_t>::max())
            fail("too many texture coordinates");
        append(texcoords_, *uv, file_);
    }

    // OBJ counts from 1, or backwards from the latest element as -1.
    std::uint32_t resolve(int index, std::size_t defined, const char* one, const char* many) {
        const auto known = static_cast<std::int64_t>(defined);
        const std::int64_t at = index > 0 ? index - std::int64_t{1} : known + index;
        if (at < 0 || at >= known) {
            fail(std::string("a face uses ") + one + " " + std::to_string(index) + ", but " +
                 std::to_string(known) + " " + many + " are defined above it");
        }
        return static_cast<std::uint32_t>(at);
    }

    void add_corner(const tinyobj::index_t& index) {
        if (index.vertex_index == 0) fail("a face's vertex index is 0 or no number; indices count from 1");
        corners_.push_back(resolve(index.vertex_index, out_.mesh.positions.size(), "vertex", "vertices"));
        Vec2 uv{0.0f, 0.0f};
        if (index.texcoord_index != 0) {  // 0: none
            uv = texcoords_[resolve(index.texcoord_index, texcoords_.size(), "texture coordinate",
                                    "texture coordinates")];
            textured_ = true;
        }
        uvs_.push_back(uv);
    }

    void add_face(std::span<const tinyobj::index_t> indices) {
        if (indices.size() < 3) fail("a face needs three vertices");
        if (indices.size() > kMostCorners)
            fail("a face of " + std::to_string(indices.size()) + " corners; " + std::to_string(kMostCorners) +
                 " are the most, so export the mesh as triangles");
        corners_.clear();
        uvs_.clear();
        textured_ = false;
        for (const tinyobj::index_t& index : indices) add_corner(index);
        if (material_ == kNoMaterial) use_material("");
        if (corners_.size() == 3) {
            add_triangle({0, 1, 2});
        } else {
            for (const auto& triangle : triangulate(out_.mesh.positions, corners_)) add_triangle(triangle);
        }
    }

    // `at` names corners of the face at hand.
    void add_triangle(const std::array<std::uint32_t, 3>& at) {
        const auto& positions = out_.mesh.positions;
        const std::array<std::uint32_t, 3> triangle = {corners_[at[0]], corners_[at[1]], corners_[at[2]]};
        const Vec3 a = positions[triangle[0]], b = positions[triangle[1]], c = positions[triangle[2]];
        const bool bad_vertex = !usable(a) || !usable(b) || !usable(c);
        if (bad_vertex || !has_area(a, b, c)) {
            DroppedTriangles& dropped = out_.dropped;
            if (dropped.total() == 0) dropped.first_line = text_.line_number();
            ++(bad_vertex ? dropped.bad_vertex : dropped.zero_area);
            return;
        }
        if (out_.mesh.triangles.size() == std::numeric_limits<std::int32_t>::max())
            fail("too many triangles");
        if (textured_) {
            out_.mesh.texcoords.resize(out_.mesh.triangles.size());  // earlier faces may have had none
            append(out_.mesh.texcoords, {uvs_[at[0]], uvs_[at[1]], uvs_[at[2]]}, file_);
        }
        append(out_.mesh.triangles, triangle, file_);
        append(out_.mesh.material, material_, file_);
    }

    void use_material(std::string_view given) {
        const std::string name(given.substr(0, given.find_last_not_of(" \t") + 1));
        const auto [known, added] =
            material_ids_.try_emplace(name, static_cast<std::uint32_t>(out_.materials.size()));
        if (added) out_.materials.push_back({name, text_.line_number()});
        material_ = known->second;
    }

    ObjText text_;
    const std::string& file_;
    ObjMesh out_;
    std::vector<Vec2> texcoords_;
    std::vector<std::uint32_t> corners_;  // of the face at hand
    std::vector<Vec2> uvs_;               // of its corners
    bool textured_ = false;               // whether it names any
    std::unordered_map<std::string, std::uint32_t> material_ids_;
    std::uint32_t material_ = kNoMaterial;  // what usemtl said last
};

}  // namespace

ObjMesh parse_obj(std::string_view text, const std::string& file) {
    if (text.empty())
        throw Error(ExitCode::usage, file + ": the OBJ file is empty; fetch or export it again");
    ObjMesh parsed = ObjParser(text, file).parse();
    if (!parsed.mesh.triangles.empty()) return parsed;
    if (parsed.dropped.total() == 0) {
        throw Error(ExitCode::usage, file + ": no faces found; is it an OBJ file with a mesh?");
    }
    throw Error(
        ExitCode::usage,
        file + ": none of its " + std::to_string(parsed.dropped.total()) +
            " triangles can be used: their vertices are NaN, infinite or beyond 1e18, or they have no "
            "area; the first is on line " +
            std::to_string(parsed.dropped.first_line));
}

}  // namespace ctpbench
