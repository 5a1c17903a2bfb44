#include "wavefront/type_choice.h"

#include <algorithm>
#include <iterator>

#include "config/cells.h"
#include "kernels/platform.h"
#include "kernels/rng.h"

namespace ctpbench {
namespace {

// Neighbours in the mesh.
constexpr std::uint32_t kRun = 64;

struct Named {
    std::string name;
    TypeChoice choice;
};

std::vector<Named> named_choices() {
    std::vector<Named> all{{kTypesOfScene, {true}}, {kAllTypes, {false}}};
    const auto add = [&](const std::string& suffix, SyntheticTypes types, std::uint32_t first,
                         std::uint32_t used) {
        all.push_back({"synthetic_" + std::to_string(types.listed) + suffix, {false, types, first, used}});
    };
    for (const std::uint32_t listed : kSyntheticLists) add("", {listed, false}, 0, listed);
    for (const std::uint32_t used : kSyntheticLists)
        if (used < kMaxSyntheticTypes)
            add("_using_" + std::to_string(used), {kMaxSyntheticTypes, false}, 0, used);
    for (const std::uint32_t listed : kLargeSyntheticLists) {
        add("_using_" + std::to_string(listed - 1), {listed, false}, 0, listed - 1);
        add("_large", {listed, true}, 0, listed - 1);
        add("_large_unused", {listed, true}, 1, listed - 1);
    }
    return all;
}

}  // namespace

std::vector<std::string> type_choices() {
    std::vector<std::string> names;
    for (const Named& n : named_choices()) names.push_back(n.name);
    return names;
}

TypeChoice type_choice(const std::string& name) {
    for (const Named& n : named_choices())
        if (n.name == name) return n.choice;
    if (name == own_way) return {};
    trap();
}

bool types_built(const std::string& types) {
    const SyntheticTypes synthetic = type_choice(types).synthetic;
    return !synthetic.any() || std::find(std::begin(kBuiltLists), std::end(kBuiltLists), synthetic.listed) !=
                                   std::end(kBuiltLists);
}

std::string types_obstacle(const std::string& types, bool default_methods, std::uint32_t spheres) {
    if (!type_choice(types).synthetic.any()) return {};
    if (!types_built(types))
        return "this program was built with CTPBENCH_FEW_TYPES, without types \"" + types +
               "\"; build it again with that OFF";
    if (!default_methods)
        return "types \"" + types +
               "\" are compiled for the default methods alone; leave out methods, tests and offset, or "
               "choose types \"" +
               kTypesOfScene + "\" or \"" + kAllTypes + "\"";
    if (spheres > 0) return "types \"" + types + "\" are triangles; set /matrix/spheres to 0";
    return {};
}

bool types_on_device(const std::string& types, bool renders) {
    const SyntheticTypes synthetic = type_choice(types).synthetic;
    const bool listed = std::find(std::begin(kDeviceSyntheticLists), std::end(kDeviceSyntheticLists),
                                  synthetic.listed) != std::end(kDeviceSyntheticLists);
    return !synthetic.any() || (renders && listed && !synthetic.large);
}

std::string intersected_on_device(const std::string& types) {
    return type_choice(types).synthetic.any() ? kTypesOfScene : types;
}

std::uint32_t synthetic_material(std::uint32_t triangle) {
    const float draw = random4(0, triangle / kRun, 0, 0, Dimension::direction).v[0];
    return static_cast<std::uint32_t>(draw * static_cast<float>(kSyntheticMaterials));
}

std::uint8_t synthetic_type(const TypeChoice& choice, std::uint32_t material) {
    return static_cast<std::uint8_t>(choice.first_used + material % choice.used);
}

}  // namespace ctpbench
