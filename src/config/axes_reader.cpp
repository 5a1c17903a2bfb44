#include "config/axes_reader.h"

#include <algorithm>
#include <string_view>

#include "base/suggest.h"

namespace ctpbench {
namespace {

class ElementReader {
public:
    ElementReader(std::string_view axis, const KnownNames& known)
        : axis_(axis), allowed_(axis_range(axis)), known_(known) {}

    bool read(const JsonValue& element, std::string& value) const {
        if (!element.read(value)) return false;
        return axis_ == "scene" ? is_scene_name(element, value) : is_choice(element, value);
    }
    bool read(const JsonValue& element, std::uint32_t& value) const { return element.read(value, allowed_); }
    bool read(const JsonValue& element, double& value) const { return element.read(value, allowed_); }
    bool read(const JsonValue& element, bool& value) const { return element.read(value); }

private:
    // Which scenes there are shows only when they are loaded.
    static bool is_scene_name(const JsonValue& element, const std::string& name) {
        if (!name.empty() && name.find('/') == std::string::npos) return true;
        element.error("give a scene file's name without folder and \".json\"; --scene-dir adds folders");
        return false;
    }

    bool is_choice(const JsonValue& element, const std::string& name) const {
        const std::vector<std::string> choices = axis_choices(axis_, known_);
        if (std::find(choices.begin(), choices.end(), name) != choices.end()) return true;
        element.error(unknown_name(axis_, name, choices));
        return false;
    }

    std::string_view axis_;
    Range allowed_;
    const KnownNames& known_;
};

template <class T>
void read_axis(const JsonValue& written, const ElementReader& reader, std::vector<T>& values) {
    std::vector<T> read;
    const std::vector<JsonValue> elements = written.list_or_one();
    if (elements.empty()) written.error("an axis needs a value; give one, or remove the key");
    if (elements.size() > max_axis_values)
        return written.error("more than " + std::to_string(max_axis_values) +
                             " values along one axis; split the experiment");
    for (const JsonValue& element : elements) {
        T value{};
        if (!reader.read(element, value)) continue;
        if (std::find(read.begin(), read.end(), value) != read.end()) {
            element.error("is here twice; remove one of the two");
        } else {
            read.push_back(value);
        }
    }
    if (!read.empty()) values = std::move(read);
}

}  // namespace

std::vector<std::string> axis_choices(std::string_view axis, const KnownNames& known) {
    const auto or_of_bundle = [](std::vector<std::string> names) {
        names.insert(names.begin(), of_bundle);
        return names;
    };
    if (axis == "strategy") return known.all_strategies();
    if (axis == "traversal") return known.traversals;
    if (axis == "methods") return known.methods;
    if (axis == "builder") return known.builders;
    if (axis == "backend") return known.backends;
    if (axis == "shade") return known.all_shades();
    if (axis == "launch") return known.launches;
    if (axis == "types") return known.types;
    if (axis == "triangle_test") return or_of_bundle(known.triangle_tests);
    if (axis == "sphere_test") return or_of_bundle(known.sphere_tests);
    if (axis == "box_test") return or_of_bundle(known.box_tests);
    if (axis == "offset") return or_of_bundle(known.offsets);
    return {};
}

Range axis_range(std::string_view axis) {
    if (axis == "sphere_radius") return {0, 10, false};
    return range(0, axis == "bounce_limit" ? max_bounces : axis == "threads" ? max_threads : max_spheres);
}

std::string meaningless(std::string_view axis, const Config& config) {
    if (!config.measure && !is_workload_axis(axis)) return "means nothing as \"measure\" is false";
    const bool of_speed = is_workload_axis(axis) || axis == "restart_carries_t" || axis == "shade" ||
                          axis == "launch" || axis == "bounce_limit" || axis == "roulette" ||
                          axis == "threads";
    if (config.study == Study::stability && of_speed)
        return "means nothing in a stability study, whose workloads are \"stress\"";
    return {};
}

void read_axes(const JsonObject& object, const Config& config, const KnownNames& known, Axes& axes) {
    for_each_axis(axes, [&](std::string_view axis, auto& values) {
        const JsonValue value = object.value(axis);
        if (!value.present()) return;
        if (const std::string why = meaningless(axis, config); !why.empty()) {
            value.error(why + "; remove one of the two");
        } else {
            read_axis(value, ElementReader(axis, known), values);
        }
    });
}

}  // namespace ctpbench
