// The cache's file format: a header, then the parsed mesh's arrays and names as they lie in memory. It is
// read back on the machine that wrote it; elsewhere its magic number does not match and it is written anew.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

#include "scene/obj_mesh.h"

namespace ctpbench {

// Names a mesh: XXH3-128 of the OBJ file's bytes.
struct MeshKey {
    std::uint64_t high = 0;
    std::uint64_t low = 0;

    static MeshKey of(std::string_view obj_bytes);
    // `0123...cdef-v2.mesh`: the format is part of the name, so that versions do not replace each other's
    // files.
    std::string file_name() const;
    bool operator==(const MeshKey&) const = default;
};

// Nothing unless the file's magic number, key, sizes and checksum are all right.
std::optional<ObjMesh> read_cached_mesh(const std::filesystem::path& path, const MeshKey& key);

// Appears under its name only when complete. Throws std::system_error.
void write_cached_mesh(const std::filesystem::path& path, const MeshKey& key, const ObjMesh& mesh);

}  // namespace ctpbench
