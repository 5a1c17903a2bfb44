#include "config/study_reader.h"

#include <algorithm>

#include "base/suggest.h"

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
    if (config.study == Study::speed || is_of(Study::stability, root, "stress_rays", config))
        root.get("stress_rays", config.stress_rays, range(1, max_rays));
    if (is_of(Study::convergence, root, "seeds", config)) root.get("seeds", config.seeds, range(2, 1000));
    if (is_of(Study::convergence, root, "samples", config) &&
        root.get("samples", config.samples, range(64, 1u << 20)) &&
        (config.samples & (config.samples - 1)) != 0)
        root.error("samples", "must be a power of two: errors are taken after each doubling");
    if (is_of(Study::convergence, root, "reference_samples", config))
        root.get("reference_samples", config.reference_samples, range(2, 1u << 24));
}

}  // namespace ctpbench
