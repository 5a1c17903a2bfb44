#include "experiment.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <optional>
#include <set>

#include "backends/cuda.h"
#include "contests.h"
#include "convergence.h"
#include "measure/scene_result.h"
#include "oracle/embree.h"
#include "report/console.h"
#include "report/convergence.h"
#include "report/figures.h"
#include "report/frame_tables.h"
#include "report/growth.h"
#include "report/image.h"
#include "report/meta.h"
#include "report/pareto.h"
#include "report/peers.h"
#include "report/profile.h"
#include "report/summary.h"
#include "report/tables.h"
#include "report/tree_tables.h"
#include "report/type_tables.h"
#include "run_context.h"
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

// One run of one config: what outlives a workload.
class Run {
public:
    Run(const Config& config, const RunOptions& options, std::optional<CudaDevice> device)
        : config_(config),
          options_(options),
          device_(std::move(device)),
          id_(run_id_of(config)),
          folder_(options.out.empty() ? std::filesystem::path("results") / id_ : options.out),
          backend_(static_cast<int>(config.threads)),
          progress_(options.quiet),
          rows_(prepared(folder_, config), id_, config.experiment, backend_.threads()),
          context_{config_, folder_,  backend_,      pools_,     progress_,
                   rows_,   results_, options.quiet, options.isa} {
        if (config.study == Study::stability) stability_.emplace(folder_);
        write_meta("running");
        if (!options.notice.empty()) context_.note(options.notice);
    }

    ExitCode run(const std::vector<WorkloadCells>& workloads) {
        if (config_.measure && !stability_ && embree_version().empty())
            context_.note(
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
        const std::string table =
            stability_ ? stability_text(stability_rows_) : table_text(config_, results_);
        if (!options_.quiet) std::printf("%s\nresults: %s\n", table.c_str(), folder_.string().c_str());
        return code;
    }

private:
    // Before anything is measured: whether what will be measured can be written.
    static const std::filesystem::path& prepared(const std::filesystem::path& folder, const Config& config) {
        create_output_folder(folder);
        if (config.images) require_image_output(folder / "image.exr");
        return folder;
    }
    void write_meta(const std::string& state) {
        write_file(folder_ / "meta.json",
                   meta_json(config_, results_, id_, state, options_.command, backend_.threads(),
                             device_ ? &*device_ : nullptr, options_.isa));
    }
    void write_tables() {
        write_file(folder_ / "trees.csv", trees_csv(results_));
        if (config_.measure) write_file(folder_ / "summary.csv", summary_csv(config_, results_));
        if (config_.study == Study::convergence) {
            write_file(folder_ / "convergence.csv", convergence_csv(config_, results_));
            write_file(folder_ / "convergence_fits.csv", convergence_fits_csv(config_, results_));
        }
        for (const std::string& table : config_.tables) {
            if (table == "table2") {
                write_file(folder_ / "table2.csv", table2_csv(results_));
                write_file(folder_ / "table2.md", table2_markdown(results_));
            }
            if (table == "table3") {
                write_file(folder_ / "table3.csv", table3_csv(results_));
                write_file(folder_ / "table3.md", table3_markdown(results_));
            }
            if (table == "table1") {
                write_file(folder_ / "table1.csv", table1_csv(results_));
                write_file(folder_ / "table1.md", table1_markdown(results_));
            }
            if (table == "narrowing") write_file(folder_ / "narrowing.csv", narrowing_csv(results_));
            if (table == "types") write_file(folder_ / "types.csv", types_csv(results_));
            if (table == "pareto") write_file(folder_ / "pareto.csv", pareto_csv(config_, results_));
            if (table == "profile") write_file(folder_ / "profile.csv", profile_csv(results_));
            if (table == "peers") write_file(folder_ / "peers.csv", peers_csv(results_, backend_.threads()));
            if (table == "growth")
                write_file(folder_ / "growth.csv", growth_csv(results_, backend_.threads()));
            if (table == "figure4") write_file(folder_ / "figure4.csv", figure4_csv(config_, results_));
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
        for (const std::string& n : notices) context_.note(n);
        return scene;
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
        if (stability_) return run_stability_study(context_, cells, *stability_, stability_rows_);
        const Scene scene = load(cells.workload);
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
        progress_.step("profiling rays in flight", kTrees);
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
    std::optional<CudaDevice> device_;  // none: no cell is for CUDA
    std::string id_;
    std::filesystem::path folder_;
    CpuBackend backend_;
    ThreadPools pools_{backend_};
    Progress progress_;
    Results results_;
    RowsFile rows_;
    RunContext context_;
    std::optional<StabilityFile> stability_;  // of a stability study
    std::vector<StabilityRow> stability_rows_;
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
    const bool on_cuda = std::any_of(cells.begin(), cells.end(), [](const Cell& cell) {
        return cell.contender && cell.contender->backend == "cuda";
    });
    std::optional<CudaDevice> device;
    if (on_cuda) device = use_cuda_device(options.device);
    return Run(config, options, std::move(device)).run(group_by_workload(cells));
}

}  // namespace ctpbench
