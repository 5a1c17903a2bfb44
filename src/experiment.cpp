#include "experiment.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <optional>
#include <set>

#include "base/interrupt.h"
#include "kernels/methods/bundles.h"
#include "measure/contest.h"
#include "measure/lineup.h"
#include "oracle/embree.h"
#include "report/console.h"
#include "report/figures.h"
#include "report/meta.h"
#include "report/progress.h"
#include "report/rows.h"
#include "report/summary.h"
#include "report/tables.h"
#include "wavefront/forest.h"
#include "wavefront/paths.h"

namespace ctpbench {
namespace {

// Shares of a workload's time, for the progress line.
constexpr double kScene = 0.03, kTrees = 0.30, kOracle = 0.40, kFrame = 0.45, kVerified = 0.55;

struct Interrupted {};

std::string run_id_of(const Config& config) {
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    char text[32];
    std::strftime(text, sizeof text, "%Y%m%dT%H%M%SZ", std::gmtime(&now));
    return config.experiment + "-" + text;
}

// One run of one config: what outlives a workload.
class Run {
public:
    Run(const Config& config, const RunOptions& options)
        : config_(config),
          options_(options),
          id_(run_id_of(config)),
          folder_(options.out.empty() ? std::filesystem::path("results") / id_ : options.out),
          backend_(static_cast<int>(config.threads)),
          progress_(options.quiet) {
        create_output_folder(folder_);
        rows_.emplace(folder_, id_, config.experiment, backend_.threads());
        write_meta("running");
    }

    ExitCode run(const std::vector<WorkloadCells>& workloads) {
        if (config_.measure && embree_version().empty())
            note(
                "this program was built without Embree: hits are compared among contenders, but no oracle "
                "checks them");
        ExitCode code = ExitCode::ok;
        try {
            for (std::size_t i = 0; i < workloads.size(); ++i) {
                progress_.start_workload(i, workloads.size(), workloads[i].workload.name());
                run_workload(workloads[i]);
            }
        } catch (const Interrupted&) {
            code = ExitCode::interrupted;
        }
        if (code == ExitCode::ok)
            for (const CellResult& c : results_.cells)
                if (!c.valid) code = ExitCode::oracle;
        write_tables();
        write_meta(code == ExitCode::interrupted ? "interrupted" : "complete");
        if (code == ExitCode::interrupted)
            progress_.note("interrupted: what was measured is in " + folder_.string());
        if (!options_.quiet)
            std::printf("%s\nresults: %s\n", table_text(config_, results_).c_str(), folder_.string().c_str());
        return code;
    }

private:
    void note(const std::string& text) {
        if (std::find(results_.notices.begin(), results_.notices.end(), text) != results_.notices.end())
            return;
        results_.notices.push_back(text);
        if (!options_.quiet) progress_.note(text);
    }
    void stop_if_interrupted() const {
        if (interrupted()) throw Interrupted{};
    }
    void write_meta(const std::string& state) {
        write_file(folder_ / "meta.json",
                   meta_json(config_, results_, id_, state, options_.command, backend_.threads()));
    }
    void write_tables() {
        write_file(folder_ / "trees.csv", trees_csv(results_));
        if (config_.measure) write_file(folder_ / "summary.csv", summary_csv(config_, results_));
        for (const std::string& table : config_.tables) {
            if (table == "table2") write_file(folder_ / "table2.csv", table2_csv(results_));
            if (table == "table3") {
                write_file(folder_ / "table3.csv", table3_csv(results_));
                write_file(folder_ / "table3.md", table3_markdown(results_));
            }
        }
    }

    Scene load(const Workload& workload) {
        progress_.step("loading the scene", 0.0);
        SceneRequest request;
        request.name = workload.scene;
        request.choice = options_.scenes;
        request.scene_dirs = options_.scene_dirs;
        request.spheres = workload.spheres;
        request.sphere_radius = static_cast<float>(workload.sphere_radius);
        request.seed = config_.seed;
        Notices notices;
        Scene scene = load_scene(request, notices);
        for (const std::string& n : notices) note(n);
        return scene;
    }

    Forest plant(const WorkloadCells& cells, const Scene& scene) {
        std::set<TreeKind> kinds;
        const std::vector<StrategyInfo> strategies = intersect_strategies();
        const auto need = [&](const std::string& name) {
            for (const StrategyInfo& s : strategies)
                if (s.name == name) kinds.insert(s.tree);
        };
        for (const Contender& c : cells.contenders) need(c.strategy);
        if (config_.measure)
            need(config_.reference);
        else
            kinds = {TreeKind::mixed, TreeKind::per_type};

        SbvhSettings settings;
        for (const BuilderInfo& b : tree_builders())
            if (b.name == cells.workload.builder) settings = b.settings;
        // The tree over triangles alone is the same for every number of spheres.
        const std::string key = cells.workload.scene + "/" + cells.workload.builder;
        Forest forest = build_forest(
            backend_, scene, kinds, settings, key == triangles_of_ ? triangles_ : nullptr,
            [&](const std::string& tree, double done) {
                progress_.step("building the tree (" + tree + ")", kScene + (kTrees - kScene) * done);
            });
        if (forest.per_type[0]) triangles_of_ = key, triangles_ = forest.per_type[0];
        const std::size_t triangles = scene.mesh.triangles.size(), spheres = scene.spheres.size();
        const auto record = [&](const char* kind, const std::shared_ptr<const Tree>& tree, std::size_t n) {
            if (tree) results_.trees.push_back(describe(cells.workload, kind, *tree, n));
        };
        record("mixed", forest.mixed, triangles + spheres);
        record("typed_leaves", forest.typed_leaves, triangles + spheres);
        record("triangles", forest.per_type[0], triangles);
        record("spheres", forest.per_type[1], spheres);
        return forest;
    }

    void run_workload(const WorkloadCells& cells) {
        stop_if_interrupted();
        const Scene scene = load(cells.workload);
        const char* source = scene.source == SceneSource::mesh ? "mesh" : "stand-in";
        SceneResult& in_results = results_.scenes.emplace_back();
        in_results = {scene.name,
                      cells.workload.spheres,
                      source,
                      scene.mesh.triangles.size(),
                      scene.dropped_triangles,
                      scene.content_hash,
                      0.0};
        stop_if_interrupted();
        const Forest forest = plant(cells, scene);
        stop_if_interrupted();
        if (!config_.measure) return;

        const SceneView view(scene);
        const LayoutInput input = forest.layout_input(view.geometry());
        Lineup lineup(cells.workload, scene, input, backend_.threads(), results_,
                      [&](const std::string& what) { progress_.step(what, kOracle); });
        const bool have_embree = !embree_version().empty();
        const Intersector* oracle = have_embree ? &lineup.get(kYardstick, own_way) : nullptr;
        stop_if_interrupted();

        progress_.step("tracing the reference frame", kOracle);
        std::vector<Batch> batches;
        trace_paths(
            backend_, view, scene.camera, lineup.get(config_.reference, Watertight::name),
            {config_.width, config_.height, config_.bounces, config_.seed},
            [&](std::uint32_t bounce, RayColumns rays, const std::uint32_t* index, std::uint32_t active) {
                stop_if_interrupted();
                batches.push_back(record_batch(bounce, rays, index, active, config_.batch_rays));
            });

        Contest contest(backend_, view.geometry(), batches, oracle, config_.oracle_rays);
        std::vector<Entrant> entrants;
        for (const Contender& c : cells.contenders) {
            stop_if_interrupted();
            const bool yardstick = c.methods == own_way;
            if (yardstick && !have_embree) {
                note(c.label() + ": left out, this program was built without Embree");
                continue;
            }
            CellResult cell;
            cell.workload = cells.workload, cell.contender = c;
            cell.scene_source = source, cell.triangles = scene.mesh.triangles.size();
            bool exact = false;
            for (const MethodsInfo& m : method_bundles())
                if (m.name == c.methods) exact = m.exact;
            entrants.push_back({results_.cells.size(),
                                &lineup.get(c.strategy, c.methods),
                                c.restart_carries_t,
                                exact,
                                !yardstick,
                                {}});
            progress_.step("checking " + c.label(),
                           kFrame + (kVerified - kFrame) * static_cast<double>(entrants.size()) /
                                        static_cast<double>(cells.contenders.size()));
            const std::vector<Row> rows = contest.verify(entrants.back(), cell);
            if (!cell.valid) note(cells.workload.name() + "/" + c.label() + ": rejected: " + cell.reason);
            results_.cells.push_back(std::move(cell));
            if (!results_.cells.back().valid) rows_->append(results_, rows);
        }
        in_results.sphere_hit_share = contest.sphere_hit_share();

        for (std::uint32_t round = 0; round < config_.rounds; ++round) {
            progress_.step("round " + std::to_string(round + 1) + " of " + std::to_string(config_.rounds),
                           kVerified + (1.0 - kVerified) * round / config_.rounds);
            const std::vector<Row> rows = contest.round(round, entrants, results_, interrupted);
            rows_->append(results_, rows);
            stop_if_interrupted();
        }
    }

    const Config& config_;
    const RunOptions& options_;
    std::string id_;
    std::filesystem::path folder_;
    CpuBackend backend_;
    Progress progress_;
    std::optional<RowsFile> rows_;
    Results results_;
    std::string triangles_of_;
    std::shared_ptr<const Tree> triangles_;
};

}  // namespace

KnownNames known_names() {
    KnownNames names;
    for (const StrategyInfo& s : intersect_strategies()) names.strategies.push_back(s.name);
    for (const EmbreeContender& e : embree_contenders()) names.yardsticks.push_back(e.name);
    for (const MethodsInfo& m : method_bundles()) names.methods.push_back(m.name);
    for (const BuilderInfo& b : tree_builders()) names.builders.push_back(b.name);
    names.traversals = {"single"};
    return names;
}

ExitCode run_experiment(const Config& config, const std::vector<Cell>& cells, const RunOptions& options) {
    return Run(config, options).run(group_by_workload(cells));
}

}  // namespace ctpbench
