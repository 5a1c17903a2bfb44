#include "scene/material_overrides.h"

#include <algorithm>

#include "base/error.h"
#include "base/suggest.h"
#include "base/type_names.h"
#include "kernels/materials/list.h"

namespace ctpbench {
namespace {

constexpr const char* kKeys[] = {"type", "diffuse", "specular", "exponent", "emission"};

std::optional<std::uint32_t> read_type(const JsonObject& json) {
    // A name's position is the type's number.
    const std::vector<std::string> names = names_of<Materials>();
    std::string name;
    if (!json.get("type", name, names)) return std::nullopt;
    return static_cast<std::uint32_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

template <class T>
std::optional<T> read_if_there(const JsonObject& json, const char* key, const Range& allowed) {
    T value{};
    return json.get(key, value, allowed) ? std::optional<T>(value) : std::nullopt;
}

template <class T>
void assign(T& to, const std::optional<T>& from) {
    if (from) to = *from;
}

}  // namespace

std::vector<MaterialOverride> read_overrides(const JsonObject& json, const JsonDocument& document) {
    std::vector<MaterialOverride> overrides;
    for (const auto& [name, value] : json.object("materials").members()) {
        const JsonObject changes = value.object();
        MaterialOverride change;
        change.material = name;
        change.type = read_type(changes);
        change.diffuse = read_if_there<Vec3>(changes, "diffuse", range(0, 1));
        change.specular = read_if_there<Vec3>(changes, "specular", range(0, 1));
        change.exponent = read_if_there<float>(changes, "exponent", at_least(0));
        change.emission = read_if_there<Vec3>(changes, "emission", at_least(0));
        change.place = document.key_place(value.pointer());
        const auto given = [&](const char* key) { return changes.has(key); };
        if (value.is_object() && std::none_of(std::begin(kKeys), std::end(kKeys), given))
            value.error("changes nothing; give at least one of type, diffuse, specular, exponent, emission");
        overrides.push_back(std::move(change));
    }
    return overrides;
}

void apply_overrides(const std::vector<MaterialOverride>& overrides, std::vector<Material>& materials) {
    for (const MaterialOverride& change : overrides) {
        const auto found = std::find_if(materials.begin(), materials.end(), [&](const Material& material) {
            return material.name == change.material;
        });
        if (found == materials.end()) {
            std::vector<std::string> names;
            for (const Material& material : materials) names.push_back(material.name);
            throw Error(ExitCode::usage,
                        error_line(change.place, unknown_name("material", change.material, names)));
        }
        MaterialDescription& look = found->look;
        assign(look.type, change.type);
        assign(look.diffuse, change.diffuse);
        assign(look.specular, change.specular);
        assign(look.exponent, change.exponent);
        assign(look.emission, change.emission);
    }
}

}  // namespace ctpbench
