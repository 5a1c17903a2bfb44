#include "experiment.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "backends/cuda.h"
#include "contests.h"
#include "convergence.h"
#include "measure/scene_result.h"
#include "oracle/embree.h"
#include "report/console.h"
#include "report/figures.h"
#include "report/finished.h"
#include "report/meta.h"
#include "run_context.h"
#include "run_folder.h"
#include "run_tables.h"
#include "stability_study.h"
#include "wavefront/forest.h"
#include "wavefront/interleaved/intersector.h"
#include "wavefront/interleaved/profiler.h"
#include "wavefront/methods.h"
#include "wavefront/shader.h"

namespace ctpbench {
namespace {

// Shares of a workload's time, for the progress line.
constexpr double kScene = 0.03, kTrees = 0.30;

bool is_among(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string run_id_of(const Config& config) {
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    char text[32];
    std::strftime(text, sizeof text, "%Y%m%dT%H%M%SZ", std::gmtime(&now));
    return config.experiment + "-" + text;
}

RunRecord record_of(const Config& config, const std::vector<Cell>& cells, const RunOptions& options,
                    int threads) {
    RunRecord record;
    record.run_id = run_id_of(config), record.command = options.command;
    record.shard = options.shard, record.isa = options.isa, record.threads = threads;
    record.workloads = plan(config, cells, options.isa, threads);
    if (any_on_cuda(cells)) record.device = use_cuda_device(options.device);
    return record;
}

Scene load(const Workload& workload, const Config& config, const RunOptions& options, Notices& notices) {
    SceneRequest request;
    request.name = workload.scene;
    request.choice = options.scenes;
    request.scene_dirs = options.scene_dirs;
    request.spheres = workload.spheres;
    request.sphere_radius = static_cast<float>(workload.sphere_radius);
    request.seed = config.seed;
    return load_scene(request, notices);
}

// One run of one config: what outlives a workload.
class Run {
public:
    Run(const Config& config, const std::vector<Cell>& cells, const RunOptions& options)
        : config_(config),
          options_(options),
          backend_(static_cast<int>(config.threads)),
          record_(record_of(config, cells, options, backend_.threads())),
          folder_(options.out.empty() ? std::filesystem::path("results") / record_.run_id : options.out),
          progress_(options.quiet),
          kept_(open_run_folder(folder_, config, record_, options.resume,
                                [&](const Workload& w) {
                                    Notices unheard;
                                    return describe(load(w, config, options, unheard), w.spheres);
                                })),
          rows_(folder_, record_.run_id, config.experiment, backend_.threads(), kept_.rows_bytes),
          finished_(folder_, kept_.bytes),
          context_{config_, folder_,  backend_,      pools_,     progress_,
                   rows_,   results_, options.quiet, options.isa} {
        for (const FinishedWorkload& w : kept_.workloads) append(results_, w.results);
        if (config.study == Study::stability) {
            stability_.emplace(folder_);
            for (const StabilityRow& row : results_.stability) stability_->append(row);
        }
        if (!options.notice.empty()) context_.note(options.notice);
    }

    ExitCode run() {
        if (config_.measure && !stability_ && embree_version().empty())
            context_.note(
                "this program was built without Embree: hits are compared among contenders, but no oracle "
                "checks them");
        if (!record_.resumed.empty() && !options_.quiet) progress_.note(resumed_text());
        ExitCode code = ExitCode::ok;
        try {
            run_workloads(pending());
        } catch (const Interrupted&) {
            code = ExitCode::interrupted;
        } catch (const Error& error) {
            if (error.code() != ExitCode::output) throw;
            throw Error(error.code(),
                        std::string(error.what()) +
                            "; workloads that were finished are kept, and the same command with "
                            "--resume goes on after them");
        }
        if (code == ExitCode::ok)
            for (const CellResult& c : results_.cells)
                if (!c.valid) code = ExitCode::oracle;
        write_tables(folder_, config_, results_, backend_.threads());
        write_meta(folder_, meta_of(config_, record_, results_,
                                    code == ExitCode::interrupted ? "interrupted" : "complete"));
        if (code == ExitCode::interrupted && !options_.on_workload)
            progress_.note("interrupted: what was measured is in " + folder_.string());
        const std::string table =
            stability_ ? stability_text(results_.stability) : table_text(config_, results_);
        if (!options_.quiet) std::printf("%s\nresults: %s\n", table.c_str(), folder_.string().c_str());
        return code;
    }

private:
    std::string resumed_text() const {
        std::string text = "resumed: " + std::to_string(kept_.workloads.size()) + " finished workloads in " +
                           folder_.string() + " are kept";
        if (kept_.rows_bytes > 0 && kept_.rows_cut > 0)
            text += ", and " + std::to_string(kept_.rows_cut) +
                    " bytes of rows.csv are cut, of a workload that was not finished";
        return text;
    }

    // Of this process' share, what has not been finished.
    std::vector<const PlannedWorkload*> pending() const {
        std::vector<const PlannedWorkload*> list;
        for (std::size_t i = 0; i < record_.workloads.size(); ++i) {
            const PlannedWorkload& w = record_.workloads[i];
            const bool done = std::any_of(kept_.workloads.begin(), kept_.workloads.end(),
                                          [&](const FinishedWorkload& f) { return f.hash == w.hash; });
            if (record_.shard.has(i) && !done) list.push_back(&w);
        }
        return list;
    }

    void run_workloads(const std::vector<const PlannedWorkload*>& workloads) {
        for (std::size_t i = 0; i < workloads.size(); ++i) {
            const WorkloadCells& cells = workloads[i]->cells;
            progress_.start_workload(i, workloads.size(), cells.workload.name());
            const ResultsMark before(results_);
            const std::uint64_t rows_before = rows_.file().size();
            run_workload(cells);
            finished_.append(workloads[i]->hash, rows_.file(), rows_before, before.since(results_));
            if (options_.on_workload) options_.on_workload(cells.workload, progress_.work());
        }
    }

    // What the workload's contenders traverse.
    std::set<TreeKind> kinds_of(const WorkloadCells& cells) const {
        if (!config_.measure) return {TreeKind::mixed, TreeKind::per_type};
        std::set<TreeKind> kinds;
        std::vector<StrategyInfo> strategies = intersect_strategies();
        for (const StrategyInfo& s : interleaved_strategies()) strategies.push_back(s);
        const auto need = [&](const std::string& name) {
            for (const StrategyInfo& s : strategies)
                if (s.name == name) kinds.insert(s.tree);
            if (name == kCudaYardstick) kinds.insert(TreeKind::per_type);
        };
        for (const Contender& c : cells.contenders) need(c.strategy);
        if (is_among(config_.tables, "profile")) kinds.insert(TreeKind::typed_leaves);
        const bool intersects = std::any_of(cells.contenders.begin(), cells.contenders.end(),
                                            [](const Contender& c) { return !c.renders(); });
        if (intersects) need(config_.reference);
        if (is_among(config_.tables, "pareto")) kinds.insert(TreeKind::mixed);  // the exam's
        return kinds;
    }

    static SbvhSettings settings_of(const Workload& workload) {
        SbvhSettings settings;
        for (const BuilderInfo& b : tree_builders())
            if (b.name == workload.builder) settings = b.settings;
        return settings;
    }

    Forest plant(const WorkloadCells& cells, const Scene& scene) {
        // The tree over triangles alone is the same for every number of spheres.
        const std::string key = cells.workload.scene + "/" + cells.workload.builder;
        Forest forest = build_forest(
            backend_, scene, kinds_of(cells), settings_of(cells.workload),
            key == triangles_of_ ? triangles_ : nullptr, [&](const std::string& tree, double done) {
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
        if (stability_) return run_stability_study(context_, cells, *stability_);
        progress_.step("loading the scene", 0.0);
        Notices notices;
        const Scene scene = load(cells.workload, config_, options_, notices);
        for (const std::string& n : notices) context_.note(n);
        SceneResult& in_results = results_.scenes.emplace_back(describe(scene, cells.workload.spheres));
        stop_if_interrupted();
        const Forest forest = plant(cells, scene);
        stop_if_interrupted();
        if (!config_.measure) return;

        const SceneView view(scene);
        TypedScenes scenes(backend_, scene, view, forest, kinds_of(cells), settings_of(cells.workload));
        Lineup lineup(cells.workload, scene, scenes, backend_, options_.isa, results_,
                      [&](const std::string& what) { progress_.step(what, kTrees); });
        const Intersector* oracle =
            embree_version().empty() ? nullptr : &lineup.get(kYardstick, own_way, own_way, own_way);
        stop_if_interrupted();
        std::vector<Contender> intersecting, rendering;
        for (const Contender& c : cells.contenders) (c.renders() ? rendering : intersecting).push_back(c);
        ContestInput input{cells.workload, scene, view, scenes, lineup, oracle, in_results};
        if (is_among(config_.tables, "pareto")) input.examined = forest.mixed.get();
        input.compares = is_among(config_.tables, "peers");
        if (!intersecting.empty()) record_frame(context_, input);
        if (is_among(config_.tables, "profile")) profile(input);
        input.cuda = cuda_workload(context_, input, cells.contenders);
        if (!intersecting.empty()) run_intersect_contest(context_, input, intersecting);
        if (rendering.empty()) return;
        if (config_.study == Study::convergence)
            run_convergence(context_, input, rendering);
        else
            run_frame_contest(context_, input, rendering);
    }

    void profile(ContestInput& input) {
        progress_.step("profiling rays in flight", kTrees, Work::rays);
        const FlightProfiler profiler(backend_, input.scenes.layout(kTypesOfScene), options_.isa);
        for (Batch& batch : input.batches) {
            stop_if_interrupted();
            profiler.trace(batch);  // warms up
            results_.profiles.push_back(
                {input.workload, batch.bounce, batch.rays.size(), options_.isa, profiler.trace(batch)});
        }
    }

    const Config& config_;
    const RunOptions& options_;
    CpuBackend backend_;
    ThreadPools pools_{backend_};
    RunRecord record_;
    std::filesystem::path folder_;
    Progress progress_;
    Results results_;
    FinishedLog kept_;  // from before, if the run is resumed
    RowsFile rows_;
    FinishedFile finished_;
    RunContext context_;
    std::optional<StabilityFile> stability_;  // of a stability study
    std::string triangles_of_;
    std::shared_ptr<const Tree> triangles_;
};

}  // namespace

KnownNames known_names() {
    KnownNames names;
    for (const StrategyInfo& s : intersect_strategies()) names.strategies.push_back(s.name);
    for (const StrategyInfo& s : interleaved_strategies())
        if (!is_among(names.strategies, s.name)) names.strategies.push_back(s.name);
    for (const EmbreeContender& e : embree_contenders()) names.yardsticks.push_back({e.name, "cpu"});
    names.yardsticks.push_back({kCudaYardstick, "cuda"});
    for (const MethodsInfo& m : method_bundles()) names.methods.push_back(m.name);
    names.shades = shade_strategies();
    for (const BuilderInfo& b : tree_builders()) names.builders.push_back(b.name);
    names.triangle_tests = triangle_tests(), names.sphere_tests = sphere_tests();
    names.box_tests = box_tests(), names.offsets = offsets();
    names.types = type_choices();
    names.available = [](const Contender& c) {
        return traverses(c.strategy, c.traversal, c.backend) &&
               (c.backend != "cuda" || types_on_device(c.types, c.renders()));
    };
    names.obstacle = [](const Cell& cell) {
        const Contender& c = *cell.contender;
        if (c.is_yardstick()) return std::string();
        if (c.traversal == kInterleaved) return interleaved_obstacle(intersect_key(c), c.types);
        const std::string why =
            methods_obstacle(c.strategy, c.methods, c.triangle_test, c.sphere_test, c.box_test, c.offset);
        const bool plain = intersect_key(c) == Watertight::name && offset_name(c) == Watertight::Offset::name;
        return why.empty() ? types_obstacle(c.types, plain, cell.workload.spheres) : why;
    };
    names.traversals = {kSingle, kInterleaved};
    names.studies = {"speed", "stability", "convergence"};
    names.stress = known_stress();
    return names;
}

ExitCode run_experiment(const Config& config, const std::vector<Cell>& cells, const RunOptions& options) {
    return Run(config, cells, options).run();
}

}  // namespace ctpbench
