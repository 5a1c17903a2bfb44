#include "config/schema.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>
#include <type_traits>
#include <utility>

#include "config/axes_reader.h"
#include "config/settings.h"

namespace ctpbench {
namespace {

using Json = nlohmann::ordered_json;

Json of_names(const std::vector<std::string>& names) { return {{"enum", names}}; }

template <class T>
Json of_numbers(const Range& allowed) {
    if constexpr (std::is_integral_v<T>) {
        using Limits = std::numeric_limits<T>;
        // In the type itself: a double has not all of its digits.
        const bool from_type = allowed.low < static_cast<double>(Limits::min());
        const bool to_type = allowed.high >= std::ldexp(1.0, Limits::digits);
        return {{"type", "integer"},
                {"minimum", from_type ? Limits::min() : static_cast<T>(allowed.low)},
                {"maximum", to_type ? Limits::max() : static_cast<T>(allowed.high)}};
    } else {
        return {{"type", "number"},
                {allowed.includes_low ? "minimum" : "exclusiveMinimum", allowed.low},
                {"maximum", allowed.high}};
    }
}

Json list_of(const Json& element, std::size_t least) {
    return {{"type", "array"}, {"items", element}, {"minItems", least}, {"uniqueItems", true}};
}

Json list_or_one(const Json& element, std::size_t most) {
    Json list = list_of(element, 1);
    list["maxItems"] = most;
    return {{"anyOf", {element, list}}};
}

Json described(const char* help, const Json& what) {
    Json json = {{"description", help}};
    json.update(what);
    return json;
}

constexpr std::pair<std::string_view, const char*> kAxesHelp[] = {
    {"scene", "Scene files, by name"},
    {"spheres", "Spheres scattered in the scene"},
    {"sphere_radius", "As a share of the spheres' mean spacing"},
    {"builder", "Settings that trees are built with"},
    {"backend", "What the kernels run on"},
    {"strategy", "How intersection branches on type, or a yardstick"},
    {"restart_carries_t", "Of restart: whether the hits of one pass bound the next"},
    {"traversal", "How a strategy walks its trees"},
    {"methods", "Bundles of tests and offsets"},
    {"types", "Types that kernels are compiled for"},
    {"shade", "How shading branches on type; none: recorded rays are intersected"},
    {"launch", "How the kernels of a frame are launched on a GPU"},
    {"triangle_test", "In place of the bundle's"},
    {"sphere_test", "In place of the bundle's"},
    {"box_test", "In place of the bundle's"},
    {"offset", "Of rays that leave a surface, in place of the bundle's"},
    {"bounce_limit", "Of frames, in place of bounces; 0: as those"},
    {"roulette", "Of frames: Russian roulette"},
    {"threads", "Of the CPU, for recorded rays; 0: the run's"}};

const char* help_of(std::string_view axis) {
    for (const auto& [name, help] : kAxesHelp)
        if (name == axis) return help;
    return "";
}

template <class T>
Json axis_element(const char* axis, const KnownNames& known) {
    if constexpr (std::is_same_v<T, bool>) {
        return {{"type", "boolean"}};
    } else if constexpr (std::is_arithmetic_v<T>) {
        return of_numbers<T>(axis_range(axis));
    } else {
        const std::vector<std::string> names = axis_choices(axis, known);
        if (!names.empty()) return of_names(names);
        return {{"type", "string"}, {"pattern", "^[^/]+$"}};
    }
}

Json of_axes(const KnownNames& known) {
    Json properties = Json::object();
    Axes axes;
    for_each_axis(axes, [&]<class T>(const char* axis, const std::vector<T>&) {
        properties[axis] =
            described(help_of(axis), list_or_one(axis_element<T>(axis, known), max_axis_values));
    });
    return {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
}

Json entries(const char* help, const Json& axes) {
    return {{"description", help}, {"type", "array"}, {"items", axes}, {"maxItems", max_entries}};
}

}  // namespace

Json config_schema(const KnownNames& known) {
    const Json switched = {{"type", "boolean"}}, text = {{"type", "string"}};
    const Json axes = {{"$ref", "#/definitions/axes"}};
    Json keys = {
        {"$schema", described("This schema, for editors", text)},
        {"schema_version", described("Of the format", {{"const", config_schema_version}})},
        {"experiment",
         described("Names the results", {{"type", "string"}, {"pattern", "^[A-Za-z0-9_-][A-Za-z0-9_.-]*$"}})},
        {"description", described("What the experiment shows", text)},
        {"study", described("What the experiment asks; speed if it is not here", of_names(known.studies))},
        {"measure", described("false: trees are built and counted, nothing is traced", switched)},
        {"matrix", described("Axes whose values are multiplied out", axes)},
        {"exclude", entries("What matches one of these leaves the matrix",
                            {{"allOf", Json::array({axes})}, {"minProperties", 1}})},
        {"include", entries("Further matrices, appended; an axis that is not here has its default", axes)},
        {"reference",
         described("Strategy, or shade strategy, that ratios refer to", of_names(known.all_references()))},
        {"tables", described("To be written beside the rows", list_of(of_names(known.all_tables()), 0))},
        {"images", described("Whether what frames accumulated is written as EXR and PNG", switched)},
        {"batch_bounces",
         described("Bounces whose rays are recorded, 0 being the camera's; all if it is not here",
                   list_or_one(of_numbers<std::uint32_t>(range(0, max_bounces)), max_bounces + 1))}};
    std::vector<std::string> stress;
    for (const KnownNames::Stress& s : known.stress) stress.push_back(s.name);
    keys["stress"] =
        described("Workloads of a stability study; all if it is not here", list_of(of_names(stress), 1));
    const auto add = [&]<class T>(const char* key, T Config::*, const Range& allowed, const char* help) {
        keys[key] = described(help, of_numbers<T>(allowed));
    };
    for_each_setting(add);
    for_each_study_setting([&](Study, const char* key, auto member, const Range& allowed, const char* help) {
        add(key, member, allowed, help);
    });
    // A power of two, of which the range has few.
    Json powers = Json::array();
    Json& samples = keys["samples"];
    for (std::uint64_t n = samples["minimum"]; n <= samples["maximum"]; n *= 2) powers.push_back(n);
    samples = described(samples["description"].get<std::string>().c_str(), {{"enum", powers}});
    return {{"$schema", "http://json-schema.org/draft-07/schema#"},
            {"title", "Experiment of ctpbench"},
            {"type", "object"},
            {"required", {"schema_version", "experiment"}},
            {"properties", keys},
            {"additionalProperties", false},
            {"definitions", {{"axes", of_axes(known)}}}};
}

}  // namespace ctpbench
