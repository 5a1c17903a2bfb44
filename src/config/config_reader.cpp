#include <algorithm>
#include <set>
#include <string_view>

#include "base/json_reader.h"
#include "base/suggest.h"
#include "config/axes_reader.h"
#include "config/cells.h"
#include "config/config.h"
#include "config/settings.h"
#include "config/study_reader.h"
#include "config/tables_reader.h"

namespace ctpbench {
namespace {

bool is_among(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> joined(std::vector<std::string> a, const std::vector<std::string>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

void read_header(const JsonObject& root, Config& config) {
    std::string schema;  // for editors only
    root.get("$schema", schema);
    int version = config_schema_version;
    if (root.require("schema_version", version) && version != config_schema_version) {
        root.error("schema_version", "this program reads version " + std::to_string(config_schema_version) +
                                         ", found " + std::to_string(version));
    }
    const std::string allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
    if (root.require("experiment", config.experiment) &&
        (config.experiment.empty() || config.experiment.front() == '.' ||
         config.experiment.find_first_not_of(allowed) != std::string::npos)) {
        root.error("experiment",
                   "names files: use letters, digits, '_', '-' and '.', which may not be first");
    }
    root.get("description", config.description);
}

void read_batch_bounces(const JsonObject& root, Config& config) {
    const JsonValue written = root.value("batch_bounces");
    if (!written.present()) return;
    const std::vector<JsonValue> elements = written.list_or_one();
    if (elements.empty()) written.error("leaves no rays; name bounces, or remove the key for all of them");
    for (const JsonValue& element : elements) {
        std::uint32_t bounce = 0;
        if (!element.read(bounce, range(0, config.bounces))) continue;
        if (std::find(config.batch_bounces.begin(), config.batch_bounces.end(), bounce) !=
            config.batch_bounces.end())
            element.error("is here twice; remove one of the two");
        else
            config.batch_bounces.push_back(bounce);
    }
}

// Recorded rays alone are traced by as many threads of the CPU as a contender asks for.
void check_threads(const JsonObject& written, const Axes& axes) {
    const JsonValue threads = written.value("threads");
    if (std::all_of(axes.threads.begin(), axes.threads.end(), [](std::uint32_t n) { return n == 0; })) return;
    if (std::any_of(axes.shade.begin(), axes.shade.end(), [](const auto& s) { return s != no_shade; }))
        threads.error(
            "frames are rendered by the run's own threads; name shade strategies in an entry of /include, "
            "without threads");
    else if (!is_among(axes.backend, "cpu"))
        threads.error("concerns the CPU alone; add backend \"cpu\", or remove it");
}

void check_stop_rules(const JsonObject& root, const Config& config) {
    for (const char* key : {"min_time", "max_noise", "timeout"})
        if (root.has(key) && config.study != Study::speed)
            root.error(key, "belongs to studies of speed; remove it");
    if (config.max_noise > 0.0 && config.timeout == 0.0)
        root.error("max_noise", "may never be reached; give a timeout too, in seconds");
    if (config.timeout > 0.0 && config.timeout < config.min_time)
        root.error("timeout", "is shorter than min_time; lengthen it");
}

void read_settings(const JsonObject& root, Config& config) {
    for_each_setting([&](const char* key, auto member, const Range& allowed, const char*) {
        root.get(key, config.*member, allowed);
    });
    check_stop_rules(root, config);
    read_batch_bounces(root, config);
    root.get("images", config.images);
}

// Whether multiplying out is affordable beside the cells that there are already; an error otherwise.
bool is_small(const Axes& axes, std::size_t already, const JsonValue& place) {
    double cells = 1;
    for_each_axis(axes, [&](std::string_view, const auto& values) {
        cells *= static_cast<double>(std::max<std::size_t>(values.size(), 1));
    });
    if (cells + static_cast<double>(already) <= static_cast<double>(max_cells)) return true;
    place.error("makes more than " + std::to_string(max_cells) + " cells; split the experiment");
    return false;
}

// A list of axes, `exclude` or `include`.
std::vector<JsonValue> read_entries(const JsonObject& root, const char* key) {
    std::vector<JsonValue> entries = root.list(key);
    if (entries.size() <= max_entries) return entries;
    root.error(key, "more than " + std::to_string(max_entries) + " entries; split the experiment");
    return {};
}

// Ratios need someone to refer to, in the contest of intersections and in that of frames.
void check_reference(const JsonObject& root, const std::vector<Cell>& cells, const std::string& reference) {
    for (const bool renders : {false, true}) {
        const auto takes_part = [&](const Cell& cell) { return cell.contender->renders() == renders; };
        const auto is_reference = [&](const Cell& cell) {
            return takes_part(cell) &&
                   (renders ? cell.contender->shade : cell.contender->strategy) == reference;
        };
        if (std::any_of(cells.begin(), cells.end(), takes_part) &&
            std::none_of(cells.begin(), cells.end(), is_reference)) {
            root.value("reference")
                .error("\"" + reference + "\" is not among the strategies measured; add it to /matrix/" +
                       (renders ? "shade" : "strategy") + " or refer to another");
        }
    }
}

// Contenders that the program has not, each reason once.
void check_obstacles(const JsonObject& root, const std::vector<Cell>& cells, const KnownNames& known) {
    if (!known.obstacle) return;
    std::set<std::string> reasons;
    for (const Cell& cell : cells) {
        const std::string why = cell.contender ? known.obstacle(cell) : "";
        if (!why.empty() && reasons.insert(why).second)
            root.value("matrix").error(cell.name() + " cannot be had: " + why);
    }
}

// What only the whole matrix can tell: the default tables too.
void check_cells(const JsonObject& root, const KnownNames& known, Config& config) {
    if (!is_small(config.matrix, 0, root.value("matrix"))) return;
    Config without_include = config;
    without_include.include.clear();
    std::vector<Cell> cells = expand(without_include, known);
    std::set<std::string> names;
    for (const Cell& cell : cells) names.insert(cell.name());
    const std::vector<JsonValue> includes = root.list("include");
    for (std::size_t i = 0; i < includes.size(); ++i) {
        if (!is_small(config.include[i], cells.size(), includes[i])) return;
        for (const Cell& cell : expand_axes(config.include[i], config, known)) {
            if (!names.insert(cell.name()).second)
                includes[i].error(cell.name() + " is there already; remove it here");
            cells.push_back(cell);
        }
    }
    if (cells.empty()) {
        root.value("exclude").error("leaves nothing of the matrix; exclude less");
        return;
    }
    check_obstacles(root, cells, known);
    if (config.measure && config.study == Study::speed) check_reference(root, cells, config.reference);
    const bool all_render = std::all_of(cells.begin(), cells.end(), [](const Cell& cell) {
        return cell.contender && cell.contender->renders();
    });
    if (config.study != Study::speed) {
        for (const JsonValue& element : root.list("tables"))
            element.error("belongs to studies of speed; this study writes its own table");
        if (config.images) root.error("images", "belongs to studies of speed; remove it");
        if (root.has("batch_bounces")) root.error("batch_bounces", "belongs to studies of speed; remove it");
        if (config.study == Study::convergence && !all_render)
            root.value("matrix").error(
                "every contender must render; name shade strategies, without \"none\"");
        return;
    }
    check_tables(root, cells, known, config);
}

}  // namespace

const KnownNames::Yardstick* KnownNames::yardstick(const std::string& name) const {
    for (const Yardstick& y : yardsticks)
        if (y.name == name) return &y;
    return nullptr;
}
const KnownNames::Stress* KnownNames::find_stress(const std::string& name) const {
    for (const Stress& s : stress)
        if (s.name == name) return &s;
    return nullptr;
}
std::vector<std::string> KnownNames::all_strategies() const {
    std::vector<std::string> names = strategies;
    for (const Yardstick& y : yardsticks) names.push_back(y.name);
    return names;
}
std::vector<std::string> KnownNames::all_shades() const { return joined({no_shade}, shades); }
std::vector<std::string> KnownNames::all_references() const {
    std::vector<std::string> names = all_strategies();
    for (const std::string& shade : shades)
        if (!is_among(names, shade)) names.push_back(shade);
    return names;
}
std::vector<std::string> KnownNames::all_tables() const {
    std::vector<std::string> all = tree_tables;
    for (const auto* more : {&speed_tables, &frame_tables, &failure_tables, &type_tables, &peer_tables})
        all = joined(all, *more);
    return all;
}

Config read_config(JsonDocument document, const KnownNames& known) {
    JsonReader reader(std::move(document));
    const JsonObject root = reader.root();
    Config config;
    read_header(root, config);
    read_study(root, known, config);
    read_settings(root, config);
    read_tables(root, known, config);

    const JsonObject matrix = root.object("matrix");
    read_axes(matrix, config, known, config.matrix);
    check_threads(matrix, config.matrix);
    for (const JsonValue& element : read_entries(root, "exclude")) {
        read_axes(element.object(), config, known, config.exclude.emplace_back());
        if (config.exclude.back() == Axes{} && !reader.failed()) {
            element.error("would exclude everything; name an axis and its values");
        }
    }
    for (const JsonValue& element : read_entries(root, "include")) {
        read_axes(element.object(), config, known, config.include.emplace_back(default_axes()));
        check_threads(element.object(), config.include.back());
    }
    if (config.measure && !known.only_backends.empty()) {
        config.matrix.backend = known.only_backends;
        for (Axes& axes : config.include) axes.backend = known.only_backends;
    }
    const JsonValue reference = root.value("reference");
    const std::vector<std::string> contenders = known.all_references();
    if (reference.read(config.reference) && !is_among(contenders, config.reference)) {
        reference.error(unknown_name("strategy", config.reference, contenders));
    }
    if (!reader.failed()) check_cells(root, known, config);
    reader.finish();
    return config;
}

Config load_config(const std::filesystem::path& path, const std::vector<ConfigEdit>& edits,
                   const KnownNames& known) {
    JsonDocument document = JsonDocument::load(path);
    for (const ConfigEdit& edit : edits) document.set(edit.assignment, edit.option);
    return read_config(std::move(document), known);
}

}  // namespace ctpbench
