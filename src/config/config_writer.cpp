#include <algorithm>
#include <nlohmann/json.hpp>

#include "config/axes_reader.h"
#include "config/config.h"

namespace ctpbench {
namespace {

// Without the axes that have no values, and without those that mean nothing here.
nlohmann::json axes_to_json(const Axes& axes, const Config& config) {
    nlohmann::json json = nlohmann::json::object();
    for_each_axis(axes, [&](const std::string& name, const auto& values) {
        if (!values.empty() && meaningless(name, config).empty()) json[name] = values;
    });
    return json;
}

nlohmann::json list_to_json(const std::vector<Axes>& list, const Config& config) {
    nlohmann::json json = nlohmann::json::array();
    for (const Axes& axes : list) json.push_back(axes_to_json(axes, config));
    return json;
}

const char* name_of(Study study) {
    return study == Study::stability ? "stability" : study == Study::convergence ? "convergence" : "speed";
}

}  // namespace

nlohmann::json to_json(const Config& config) {
    nlohmann::json json = {{"schema_version", config_schema_version},
                           {"study", name_of(config.study)},
                           {"experiment", config.experiment},
                           {"description", config.description},
                           {"measure", config.measure},
                           {"matrix", axes_to_json(config.matrix, config)},
                           {"exclude", list_to_json(config.exclude, config)},
                           {"include", list_to_json(config.include, config)},
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
    if (!config.batch_bounces.empty()) json["batch_bounces"] = config.batch_bounces;
    if (config.study == Study::speed) {
        json["min_time"] = config.min_time;
        json["max_noise"] = config.max_noise;
        json["timeout"] = config.timeout;
    }
    if (config.study == Study::stability) json["stress"] = config.stress;
    const bool pareto =
        std::find(config.tables.begin(), config.tables.end(), "pareto") != config.tables.end();
    if (config.study == Study::stability || pareto) json["stress_rays"] = config.stress_rays;
    if (config.study == Study::convergence) {
        json["seeds"] = config.seeds;
        json["samples"] = config.samples;
        json["reference_samples"] = config.reference_samples;
    }
    return json;
}

}  // namespace ctpbench
