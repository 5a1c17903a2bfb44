#include <nlohmann/json.hpp>

#include "config/config.h"

namespace ctpbench {
namespace {

// Without the axes that have no values, and without a contender's if nothing is measured.
nlohmann::json axes_to_json(const Axes& axes, bool measure) {
    nlohmann::json json = nlohmann::json::object();
    for_each_axis(axes, [&](const std::string& name, const auto& values) {
        if (!values.empty() && (measure || is_workload_axis(name))) json[name] = values;
    });
    return json;
}

nlohmann::json list_to_json(const std::vector<Axes>& list, bool measure) {
    nlohmann::json json = nlohmann::json::array();
    for (const Axes& axes : list) json.push_back(axes_to_json(axes, measure));
    return json;
}

}  // namespace

nlohmann::json to_json(const Config& config) {
    return {{"schema_version", config_schema_version},
            {"experiment", config.experiment},
            {"description", config.description},
            {"measure", config.measure},
            {"matrix", axes_to_json(config.matrix, config.measure)},
            {"exclude", list_to_json(config.exclude, config.measure)},
            {"include", list_to_json(config.include, config.measure)},
            {"width", config.width},
            {"height", config.height},
            {"bounces", config.bounces},
            {"rounds", config.rounds},
            {"seed", config.seed},
            {"threads", config.threads},
            {"reference", config.reference},
            {"batch_rays", config.batch_rays},
            {"oracle_rays", config.oracle_rays},
            {"tables", config.tables},
            {"images", config.images}};
}

}  // namespace ctpbench
