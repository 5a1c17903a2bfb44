#include <algorithm>
#include <set>
#include <string_view>

#include "base/json_reader.h"
#include "base/suggest.h"
#include "config/axes_reader.h"
#include "config/cells.h"
#include "config/config.h"
#include "config/study_reader.h"

namespace ctpbench {
namespace {

bool is_among(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> joined(std::vector<std::string> a, const std::vector<std::string>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

constexpr double max_cells = 100'000;

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

void read_settings(const JsonObject& root, Config& config) {
    root.get("width", config.width, range(1, max_image_side));
    root.get("height", config.height, range(1, max_image_side));
    root.get("bounces", config.bounces, range(1, max_bounces));
    root.get("rounds", config.rounds, range(1, max_rounds));
    root.get("seed", config.seed);
    root.get("threads", config.threads, range(0, max_threads));
    root.get("batch_rays", config.batch_rays, range(0, max_rays));
    root.get("oracle_rays", config.oracle_rays, range(1, max_rays));
    root.get("images", config.images);
}

void read_tables(const JsonObject& root, const KnownNames& known, Config& config) {
    const std::vector<std::string> possible = config.measure ? known.all_tables() : known.tree_tables;
    const JsonValue written = root.value("tables");
    for (const JsonValue& element : written.list()) {
        std::string name;
        if (!element.read(name)) continue;
        if (!config.measure && !is_among(known.tree_tables, name) && is_among(known.all_tables(), name)) {
            element.error("needs measurements, but \"measure\" is false; change one of the two");
        } else if (!is_among(possible, name)) {
            element.error(unknown_name("table", name, possible));
        } else if (is_among(config.tables, name)) {
            element.error("is here twice; remove one of the two");
        } else {
            config.tables.push_back(name);
        }
    }
}

// Whether multiplying out is affordable; an error otherwise.
bool is_small(const Axes& axes, const JsonValue& place) {
    double cells = 1;
    for_each_axis(axes, [&](std::string_view, const auto& values) {
        cells *= static_cast<double>(std::max<std::size_t>(values.size(), 1));
    });
    if (cells <= max_cells) return true;
    place.error("makes more than 100000 cells; split the experiment");
    return false;
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
    if (!is_small(config.matrix, root.value("matrix"))) return;
    Config without_include = config;
    without_include.include.clear();
    std::vector<Cell> cells = expand(without_include, known);
    std::set<std::string> names;
    for (const Cell& cell : cells) names.insert(cell.name());
    const std::vector<JsonValue> includes = root.list("include");
    for (std::size_t i = 0; i < includes.size(); ++i) {
        if (!is_small(config.include[i], includes[i])) return;
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
    const auto all = [&](bool renders) {
        return std::all_of(cells.begin(), cells.end(), [&](const Cell& cell) {
            return cell.contender && cell.contender->renders() == renders;
        });
    };
    const auto any = [&](bool renders) {
        return std::any_of(cells.begin(), cells.end(), [&](const Cell& cell) {
            return cell.contender && cell.contender->renders() == renders;
        });
    };
    if (config.study != Study::speed) {
        for (const JsonValue& element : root.list("tables"))
            element.error("belongs to studies of speed; this study writes its own table");
        if (config.images) root.error("images", "belongs to studies of speed; remove it");
        if (config.study == Study::convergence && !all(true))
            root.value("matrix").error(
                "every contender must render; name shade strategies, without \"none\"");
        return;
    }
    if (!root.has("tables")) {
        config.tables = known.tree_tables;
        if (any(false)) config.tables = joined(config.tables, known.speed_tables);
        if (any(true)) config.tables = joined(config.tables, known.frame_tables);
    }
    for (const JsonValue& element : root.list("tables")) {
        std::string table;
        if (!any(false) && element.read(table) && is_among(known.failure_tables, table))
            element.error("needs recorded rays; add \"none\" to /matrix/shade");
    }
    const auto has_types = [&](const char* types) {
        return std::any_of(cells.begin(), cells.end(), [&](const Cell& cell) {
            return cell.contender && cell.contender->types == types;
        });
    };
    for (const JsonValue& element : root.list("tables")) {
        std::string table;
        if (!element.read(table)) continue;
        if (table == "narrowing" && !(has_types("all") && has_types("scene")))
            element.error("compares types \"all\" with \"scene\"; name both in /matrix/types");
        if (table == "types" && !has_types("synthetic_1"))
            element.error("compares with one type; name \"synthetic_1\" and others in /matrix/types");
    }
    const bool counts_failures =
        std::any_of(config.tables.begin(), config.tables.end(),
                    [&](const std::string& table) { return is_among(known.failure_tables, table); });
    if (root.has("stress_rays") && !counts_failures)
        root.error("stress_rays", "means nothing without table \"pareto\"; remove it, or add that");
    if (any(true)) return;
    constexpr const char* remedy = "needs rendered frames; name shade strategies in /matrix/shade";
    if (config.images) root.error("images", remedy);
    for (const JsonValue& element : root.list("tables")) {
        std::string table;
        if (element.read(table) && is_among(known.frame_tables, table)) element.error(remedy);
    }
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
std::vector<std::string> KnownNames::all_tables() const {
    return joined(joined(joined(joined(tree_tables, speed_tables), frame_tables), failure_tables),
                  type_tables);
}

Config read_config(JsonDocument document, const KnownNames& known) {
    JsonReader reader(std::move(document));
    const JsonObject root = reader.root();
    Config config;
    read_header(root, config);
    read_study(root, known, config);
    read_settings(root, config);
    read_tables(root, known, config);

    read_axes(root.object("matrix"), config, known, config.matrix);
    for (const JsonValue& element : root.list("exclude")) {
        read_axes(element.object(), config, known, config.exclude.emplace_back());
        if (config.exclude.back() == Axes{} && !reader.failed()) {
            element.error("would exclude everything; name an axis and its values");
        }
    }
    for (const JsonValue& element : root.list("include")) {
        read_axes(element.object(), config, known, config.include.emplace_back(default_axes()));
    }
    if (config.measure && !known.only_backends.empty()) {
        config.matrix.backend = known.only_backends;
        for (Axes& axes : config.include) axes.backend = known.only_backends;
    }
    const JsonValue reference = root.value("reference");
    std::vector<std::string> contenders = known.all_strategies();
    for (const std::string& shade : known.shades)
        if (!is_among(contenders, shade)) contenders.push_back(shade);
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
