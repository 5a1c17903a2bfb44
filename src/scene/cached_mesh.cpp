#include "scene/cached_mesh.h"

#include <unistd.h>
#include <xxhash.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <system_error>

#include "base/hash.h"
#include "scene/mapped_file.h"

namespace ctpbench {
namespace {

namespace fs = std::filesystem;

// To be raised whenever parse_obj() makes something else of the same file, or the layout below changes.
constexpr std::uint32_t kVersion = 2;
constexpr std::uint64_t kMagic =
    0x4853454d50544300u + kVersion;  // the version and "CTPMESH", in little-endian order

struct Header {
    std::uint64_t magic = kMagic;
    MeshKey key;
    std::uint64_t positions = 0, triangles = 0, texcoords = 0, names_bytes = 0;  // sizes of what follows
    DroppedTriangles dropped;
    BadTexcoords bad_texcoords;
    std::uint64_t checksum = 0;  // of the two before it and what follows
};

std::uint64_t checksum(const ObjMesh& mesh, const std::string& names) {
    std::uint64_t hash = hash_bytes(&mesh.dropped, sizeof(mesh.dropped));
    hash = hash_bytes(&mesh.bad_texcoords, sizeof(mesh.bad_texcoords), hash);
    hash = hash_vector(mesh.mesh.positions, hash);
    hash = hash_vector(mesh.mesh.triangles, hash);
    hash = hash_vector(mesh.mesh.material, hash);
    hash = hash_vector(mesh.mesh.texcoords, hash);
    return hash_bytes(names.data(), names.size(), hash);
}

// A name is a line `number name`, since neither can hold a line end; an empty line ends the list.
std::string write_names(const ObjMesh& mesh) {
    std::string text;
    for (const auto* list : {&mesh.materials, &mesh.libraries}) {
        for (const ObjName& entry : *list) text += std::to_string(entry.line) + ' ' + entry.name + '\n';
        text += '\n';
    }
    return text;
}

void read_names(std::string_view text, ObjMesh& mesh) {
    for (auto* list : {&mesh.materials, &mesh.libraries}) {
        while (true) {
            const std::string_view line = text.substr(0, text.find('\n'));
            text.remove_prefix(std::min(line.size() + 1, text.size()));
            const std::size_t space = line.find(' ');
            if (space == std::string_view::npos) break;
            list->push_back(
                {std::string(line.substr(space + 1)), std::stoull(std::string(line.substr(0, space)))});
        }
    }
}

template <class T>
void take(std::string_view& bytes, std::vector<T>& out, std::size_t count) {
    out.resize(count);
    if (count > 0) std::memcpy(out.data(), bytes.data(), count * sizeof(T));
    bytes.remove_prefix(count * sizeof(T));
}

[[noreturn]] void fail() { throw std::system_error(errno, std::generic_category()); }

template <class T>
void put(std::ofstream& file, const std::vector<T>& elements) {
    file.write(reinterpret_cast<const char*>(elements.data()),
               static_cast<std::streamsize>(elements.size() * sizeof(T)));
}

// Bytes that follow the header; compared in floating point, since a damaged header may hold any numbers.
bool sizes_match(const Header& header, std::size_t bytes) {
    const double expected = static_cast<double>(header.positions) * sizeof(Vec3) +
                            static_cast<double>(header.triangles) * 4 * sizeof(std::uint32_t) +
                            static_cast<double>(header.texcoords) * 3 * sizeof(Vec2) +
                            static_cast<double>(header.names_bytes);
    return expected == static_cast<double>(bytes);
}

}  // namespace

MeshKey MeshKey::of(std::string_view obj_bytes) {
    const XXH128_hash_t hash = XXH3_128bits(obj_bytes.data(), obj_bytes.size());
    return {hash.high64, hash.low64};
}

std::string MeshKey::file_name() const {
    char name[64];
    std::snprintf(name, sizeof(name), "%016llx%016llx-v%u.mesh", static_cast<unsigned long long>(high),
                  static_cast<unsigned long long>(low), kVersion);
    return name;
}

std::optional<ObjMesh> read_cached_mesh(const fs::path& path, const MeshKey& key) {
    const MappedFile file(path);
    std::string_view bytes = file.bytes();
    Header header;
    if (bytes.size() < sizeof(header)) return std::nullopt;
    std::memcpy(&header, bytes.data(), sizeof(header));
    bytes.remove_prefix(sizeof(header));
    if (header.magic != kMagic || header.key != key || !sizes_match(header, bytes.size()))
        return std::nullopt;

    ObjMesh mesh;
    mesh.dropped = header.dropped;
    mesh.bad_texcoords = header.bad_texcoords;
    take(bytes, mesh.mesh.positions, header.positions);
    take(bytes, mesh.mesh.triangles, header.triangles);
    take(bytes, mesh.mesh.material, header.triangles);
    take(bytes, mesh.mesh.texcoords, header.texcoords);
    const std::string names(bytes);
    if (checksum(mesh, names) != header.checksum) return std::nullopt;
    read_names(names, mesh);
    return mesh;
}

void write_cached_mesh(const fs::path& path, const MeshKey& key, const ObjMesh& mesh) {
    const std::string names = write_names(mesh);
    Header header;
    header.key = key;
    header.positions = mesh.mesh.positions.size();
    header.triangles = mesh.mesh.triangles.size();
    header.texcoords = mesh.mesh.texcoords.size();
    header.names_bytes = names.size();
    header.dropped = mesh.dropped;
    header.bad_texcoords = mesh.bad_texcoords;
    header.checksum = checksum(mesh, names);

    fs::create_directories(path.parent_path());
    const fs::path unfinished = path.string() + "." + std::to_string(::getpid()) + ".tmp";
    try {
        std::ofstream file(unfinished, std::ios::binary);
        if (!file) fail();
        file.write(reinterpret_cast<const char*>(&header), sizeof(header));
        put(file, mesh.mesh.positions);
        put(file, mesh.mesh.triangles);
        put(file, mesh.mesh.material);
        put(file, mesh.mesh.texcoords);
        file << names;
        file.close();
        if (!file) fail();
        fs::rename(unfinished, path);
    } catch (const std::system_error&) {
        std::error_code ignored;
        fs::remove(unfinished, ignored);
        throw;
    }
}

}  // namespace ctpbench
