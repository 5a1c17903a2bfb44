// The values of the axis `types`: which types a contender's kernels are compiled for.
//     scene               those that the scene has; the default
//     all                 all that the suite has, whether the scene has them or not
//     synthetic_8         eight synthetic types (kernels/synthetic/), in place of the scene's own
//     synthetic_64_using_4       of which the scene has four
//     synthetic_8_large          of which the first is large, and the scene has all but the last
//     synthetic_8_large_unused   and the scene has all but that one
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "config/axes.h"
#include "kernels/materials/list.h"
#include "kernels/synthetic/types.h"

namespace ctpbench {

struct TypeChoice {
    bool narrowed = false;                   // to what the scene has
    SyntheticTypes synthetic{};              // if any, the rest is
    std::uint32_t first_used = 0, used = 0;  // the synthetic types that the scene has

    bool operator==(const TypeChoice&) const = default;
};

inline constexpr const char* kTypesOfScene = types_of_scene;
inline constexpr const char* kAllTypes = "all";

// All that a config may name, the default first.
std::vector<std::string> type_choices();

// Of one of these names; of a yardstick's, all types.
TypeChoice type_choice(const std::string& name);

// Whether this build has kernels for them on the host.
bool types_built(const std::string& types);

// Why a contender cannot be had with these types, and what can; empty if it can. Synthetic types are compiled
// for the default methods alone, and they are triangles.
std::string types_obstacle(const std::string& types, bool default_methods, std::uint32_t spheres);

// Whether a device has kernels for these types. It has a few lists of synthetic materials, whose frames
// intersect as with types `scene`, and no synthetic primitives: those take minutes to compile.
bool types_on_device(const std::string& types, bool renders);

// What a device intersects with in frames of these types.
std::string intersected_on_device(const std::string& types);

// The synthetic type of a triangle, and the number of its material among kSyntheticMaterials. Runs of
// neighbouring triangles have one type: scenes have their types by object.
inline constexpr std::uint32_t kSyntheticMaterials = 256;
std::uint32_t synthetic_material(std::uint32_t triangle);
std::uint8_t synthetic_type(const TypeChoice& choice, std::uint32_t material);

}  // namespace ctpbench
