#include "config/tables_reader.h"

#include <algorithm>
#include <string>

#include "base/suggest.h"

namespace ctpbench {
namespace {

bool is_among(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

void append(std::vector<std::string>& names, const std::vector<std::string>& more) {
    names.insert(names.end(), more.begin(), more.end());
}

// Who is measured, as far as tables care.
class Measured {
public:
    explicit Measured(const std::vector<Cell>& cells) {
        for (const Cell& cell : cells)
            if (cell.contender) contenders_.push_back(*cell.contender);
    }
    bool rays() const {
        return any([](const Contender& c) { return !c.renders(); });
    }
    bool frames() const {
        return any([](const Contender& c) { return c.renders(); });
    }
    bool rays_in_flight() const {
        return any([](const Contender& c) { return !c.renders() && c.traversal == "interleaved"; });
    }
    bool types(const char* types) const {
        return any([&](const Contender& c) { return c.types == types; });
    }
    bool strategy(const char* name) const {
        return any([&](const Contender& c) { return !c.renders() && c.strategy == name; });
    }

private:
    template <class F>
    bool any(const F& f) const {
        return std::any_of(contenders_.begin(), contenders_.end(), f);
    }
    std::vector<Contender> contenders_;
};

constexpr const char* kFramesRemedy = "needs rendered frames; name shade strategies in /matrix/shade";
constexpr const char* kRaysRemedy = "needs recorded rays; add \"none\" to /matrix/shade";

// What the table lacks, and what to do; empty if it lacks nothing.
std::string lack(const std::string& table, const Measured& measured, const KnownNames& known) {
    if (is_among(known.failure_tables, table) && !measured.rays()) return kRaysRemedy;
    if (is_among(known.frame_tables, table) && !measured.frames()) return kFramesRemedy;
    if (table == "narrowing" && !(measured.types("all") && measured.types("scene")))
        return "compares types \"all\" with \"scene\"; name both in /matrix/types";
    if (table == "types" && !measured.types("synthetic_1"))
        return "compares with one type; name \"synthetic_1\" and others in /matrix/types";
    if (table == "peers" && !measured.strategy("embree_default"))
        return "compares with rtcIntersect1 on the CPU; name \"embree_default\" and others in "
               "/matrix/strategy";
    if (table == "growth" && !measured.rays()) return kRaysRemedy;
    if (table == "profile" && !measured.rays_in_flight())
        return "profiles rays in flight; name \"interleaved\" in /matrix/traversal";
    return {};
}

}  // namespace

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

void check_tables(const JsonObject& root, const std::vector<Cell>& cells, const KnownNames& known,
                  Config& config) {
    const Measured measured(cells);
    if (!root.has("tables")) {
        config.tables = known.tree_tables;
        if (measured.rays()) append(config.tables, known.speed_tables);
        if (measured.frames()) append(config.tables, known.frame_tables);
    }
    for (const JsonValue& element : root.list("tables")) {
        std::string table;
        if (!element.read(table)) continue;
        if (const std::string why = lack(table, measured, known); !why.empty()) element.error(why);
    }
    const bool counts_failures =
        std::any_of(config.tables.begin(), config.tables.end(),
                    [&](const std::string& table) { return is_among(known.failure_tables, table); });
    if (root.has("stress_rays") && !counts_failures)
        root.error("stress_rays", "means nothing without table \"pareto\"; remove it, or add that");
    if (root.has("batch_bounces") && !measured.rays())
        root.error("batch_bounces", config.measure
                                        ? kRaysRemedy
                                        : "means nothing as \"measure\" is false; remove one of the two");
    if (config.images && !measured.frames()) root.error("images", kFramesRemedy);
}

}  // namespace ctpbench
