// What a scene file changes about materials of its mesh, by name.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/json_reader.h"
#include "scene/scene.h"

namespace ctpbench {

// What is absent stays as it is. Only "type" changes the type.
struct MaterialOverride {
    std::string material;
    std::optional<std::uint32_t> type;
    std::optional<Vec3> diffuse, specular, emission;
    std::optional<float> exponent;
    JsonPlace place;  // where the file says so
};

// Of an object `{"materials": {"NAME": {"type": "matte", ...}}}`, which may be absent.
std::vector<MaterialOverride> read_overrides(const JsonObject& json, const JsonDocument& document);

// Throws Error(usage) for a material that there is none of.
void apply_overrides(const std::vector<MaterialOverride>& overrides, std::vector<Material>& materials);

}  // namespace ctpbench
