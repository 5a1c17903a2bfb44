// An experiment as plain data: what to run, over which matrix, and what to report.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "config/axes.h"

namespace ctpbench {

class JsonDocument;
struct Cell;
struct Contender;

inline constexpr int config_schema_version = 1;
inline constexpr std::uint32_t max_image_side = 16384;
inline constexpr std::uint32_t max_spheres = 50'000'000;
inline constexpr std::uint32_t max_threads = 1024;
inline constexpr std::uint32_t max_bounces = 100;
inline constexpr std::uint32_t max_rounds = 10'000;
inline constexpr double max_seconds = 1e6;
inline constexpr double max_rays = 1u << 28;          // of a batch
inline constexpr std::size_t max_axis_values = 1000;  // along one axis
inline constexpr std::size_t max_entries = 1000;      // of `exclude`, of `include`
inline constexpr std::size_t max_cells = 100'000;     // in all

// What an experiment asks.
enum class Study {
    speed,        // how fast contenders are; with Config::measure false, how large their trees
    stability,    // how often methods fail where they are made to: contenders trace stress workloads
    convergence,  // how fast the error of a picture falls, and to what
};

struct Config {
    Study study = Study::speed;
    std::string experiment;  // names the results; letters, digits, '_', '-' and '.'
    std::string description;
    bool measure = true;  // false: trees are built and counted, nothing is traced

    Axes matrix = default_axes();
    std::vector<Axes> exclude;  // what matches one of these leaves the matrix
    std::vector<Axes> include;  // further matrices, appended; a missing axis has its default

    std::uint32_t width = 2560;  // pixels
    std::uint32_t height = 1024;
    std::uint32_t bounces = 10;  // intersections of a path after the camera ray's
    std::uint32_t rounds = 11;   // times that each contender is measured at least
    double min_time = 0.0;       // the least seconds of rounds of a contest (measure/stop_rule.h)
    double max_noise = 0.0;      // rounds go on until it is reached; 0: no matter
    double timeout = 0.0;        // the most seconds of rounds of a contest; 0: no limit
    std::uint64_t seed = 1;
    std::uint32_t threads = 0;          // 0: all that the machine allows
    std::string reference = "ctp";      // strategy (of frames: shade strategy) that ratios refer to; the
                                        // strategy also records the rays
    std::uint32_t batch_rays = 131072;  // rays timed of each bounce; 0: all
    std::vector<std::uint32_t> batch_bounces{};  // whose rays are recorded, 0 being the camera's; none: all
    std::uint32_t oracle_rays = 20000;           // rays of each bounce that the oracle checks
    std::vector<std::string> tables;             // of the paper, to be written beside the rows
    bool images = false;                         // whether what frames accumulated is written as EXR and PNG

    // Of a stability study alone.
    std::vector<std::string> stress{};     // workloads; the reader fills in all that there are
    std::uint32_t stress_rays = 1u << 20;  // of each workload; also of table "pareto"
    // Of a convergence study alone.
    std::uint32_t seeds = 8;                 // independent pictures of each contender
    std::uint32_t samples = 256;             // per pixel of the last of them: a power of two
    std::uint32_t reference_samples = 4096;  // per pixel of the picture that errors are taken from

    bool operator==(const Config&) const = default;
};

// The names that a config may use; the program passes what it has. The reader knows none by itself.
struct KnownNames {
    std::vector<std::string> strategies;
    // Also strategies, but with traversal and arithmetic of their own, and each of one backend.
    struct Yardstick {
        std::string name, backend;
    };
    std::vector<Yardstick> yardsticks;
    std::vector<std::string> traversals;
    std::vector<std::string> methods;
    std::vector<std::string> builders;
    std::vector<std::string> shades;
    std::vector<std::string> backends = {"cpu", "cuda"};
    std::vector<std::string> types;
    std::vector<std::string> launches = {"isolated", "concurrent", "graph"};
    std::vector<std::string> triangle_tests, sphere_tests, box_tests, offsets;
    // Why a contender cannot be had, and what can; empty if it can. No function: all can be.
    std::function<std::string(const Cell&)> obstacle;
    // Whether a backend has the contender; those that it has not are no cells. No function: it has all.
    std::function<bool(const Contender&)> available;
    struct Stress {
        std::string name;
        std::vector<std::string> kinds;  // of methods that can meet it, as Contender::kind() calls them
    };
    std::vector<Stress> stress;
    std::vector<std::string> studies = {"speed", "stability", "convergence"};  // in the order of Study
    std::vector<std::string> only_backends;  // if any, these run whatever backends the config names
    std::vector<std::string> tree_tables = {"table2"};              // need trees only
    std::vector<std::string> speed_tables = {"table3"};             // need measurements of intersect
    std::vector<std::string> frame_tables = {"table1", "figure4"};  // need rendered frames
    std::vector<std::string> failure_tables = {"pareto"};           // intersect, and failures beside it
    std::vector<std::string> type_tables = {"narrowing", "types"};  // either
    std::vector<std::string> peer_tables = {"peers", "growth", "profile"};  // intersect; if asked for

    const Yardstick* yardstick(const std::string& name) const;  // null: there is none of this name
    std::vector<std::string> all_strategies() const;
    std::vector<std::string> all_shades() const;
    std::vector<std::string> all_references() const;
    std::vector<std::string> all_tables() const;
    const Stress* find_stress(const std::string& name) const;  // null: there is none of this name
};

// Both throw Error(usage) with every mistake in it, each on a line with its place.
Config read_config(JsonDocument document, const KnownNames& known);

// A change from the command line: `/json/pointer=value`, and the option that asked for it.
struct ConfigEdit {
    std::string assignment;
    std::string option;
};
Config load_config(const std::filesystem::path& path, const std::vector<ConfigEdit>& edits,
                   const KnownNames& known);

// The config with every default filled in; reading that gives the same config again.
nlohmann::json to_json(const Config& config);

}  // namespace ctpbench
