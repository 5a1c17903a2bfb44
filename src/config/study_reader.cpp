#include "config/study_reader.h"

#include <algorithm>
#include <string_view>

#include "base/suggest.h"
#include "config/settings.h"

namespace ctpbench {
namespace {

// What only one study has; in another it is an error.
bool is_of(Study study, const JsonObject& root, const char* key, const Config& config) {
    if (config.study == study) return true;
    if (root.has(key)) root.error(key, "means nothing in this study; remove it");
    return false;
}

void read_stress(const JsonObject& root, const KnownNames& known, Config& config) {
    std::vector<std::string> names;
    for (const KnownNames::Stress& s : known.stress) names.push_back(s.name);
    if (!root.has("stress")) config.stress = names;
    for (const JsonValue& element : root.list("stress")) {
        std::string name;
        if (!element.read(name)) continue;
        if (std::find(names.begin(), names.end(), name) == names.end())
            element.error(unknown_name("stress workload", name, names));
        else if (std::find(config.stress.begin(), config.stress.end(), name) != config.stress.end())
            element.error("is here twice; remove one of the two");
        else
            config.stress.push_back(name);
    }
}

}  // namespace

void read_study(const JsonObject& root, const KnownNames& known, Config& config) {
    std::string study = known.studies.front();
    const JsonValue written = root.value("study");
    if (written.read(study)) {
        const auto found = std::find(known.studies.begin(), known.studies.end(), study);
        if (found == known.studies.end())
            written.error(unknown_name("study", study, known.studies));
        else
            config.study = static_cast<Study>(found - known.studies.begin());
    }
    root.get("measure", config.measure);
    if (!config.measure && config.study != Study::speed)
        root.error("measure", "a study of methods or of pictures measures; remove one of the two");

    if (is_of(Study::stability, root, "stress", config)) read_stress(root, known, config);
    for_each_study_setting([&](Study study, const char* key, auto member, const Range& allowed, const char*) {
        // Table "pareto" of a study of speed counts failures too.
        const bool shared = key == std::string_view("stress_rays") && config.study == Study::speed;
        if (shared || is_of(study, root, key, config)) root.get(key, config.*member, allowed);
    });
    if ((config.samples & (config.samples - 1)) != 0)
        root.error("samples", "must be a power of two: errors are taken after each doubling");
}

}  // namespace ctpbench
