#include "stability_study.h"

#include <map>
#include <optional>

#include "contests.h"
#include "measure/stress_bed.h"
#include "oracle/embree.h"
#include "stress/registry.h"
#include "wavefront/methods.h"

namespace ctpbench {
namespace {

// Shares of a workload's time: its trees, its reference; contenders have the rest.
constexpr double kTrees = 0.05, kReference = 0.4;

// Those who can run. Embree may be missing, and CUDA's yardstick does not know of spheres.
std::vector<Contender> able(const RunContext& run, const Scene& scene, const std::vector<Contender>& all) {
    std::vector<Contender> list;
    for (const Contender& c : all) {
        if (const std::string why = embree_obstacle(c.strategy); !why.empty())
            run.note(c.label() + ": left out, " + why);
        else if (c.strategy == kCudaYardstick && !scene.spheres.empty())
            run.note(c.label() + ": left out of workloads with spheres, which it does not intersect");
        else
            list.push_back(c);
    }
    return list;
}

// What runs use that ask for nothing, exchanged for itself or not.
bool is_default(const Contender& c) {
    if (c.is_yardstick()) return false;
    const MethodsInfo own = method_bundles().front();
    const auto kept = [](const std::string& part, const std::string& bundles) {
        return part == of_bundle || part == bundles;
    };
    return c.methods == own.name && kept(c.triangle_test, own.triangle_test) &&
           kept(c.sphere_test, own.sphere_test) && kept(c.box_test, own.box_test) &&
           kept(c.offset, own.offset);
}

}  // namespace

std::vector<KnownNames::Stress> known_stress() {
    std::vector<KnownNames::Stress> known;
    for (const StressInfo& info : stress_workloads()) {
        std::vector<std::string> kinds{"bundle"};
        if (info.kinds.triangle) kinds.push_back("triangle");
        if (info.kinds.sphere) kinds.push_back("sphere");
        if (info.kinds.box) kinds.push_back("box");
        if (info.kinds.offset) kinds.push_back("offset");
        known.push_back({info.name, kinds});
    }
    return known;
}

void run_stability_study(const RunContext& run, const WorkloadCells& cells, StabilityFile& file) {
    const auto step = [&](const std::string& what, double share, Work work = Work::rays) {
        stop_if_interrupted();
        run.progress.step(what, share, work);
    };
    const auto safe_point = [&] { step("tracing the reference", kTrees); };
    step("building the trees", 0.0, Work::once);
    StressBed bed(run.backend, make_stress(cells.workload.scene, run.config.seed));
    const StressWorkload& stress = bed.workload();
    const std::vector<Contender> contenders = able(run, stress.scene, cells.contenders);
    Lineup lineup(cells.workload, stress.scene, bed.scenes(), run.backend, run.isa, run.results,
                  [](const std::string&) {});
    SceneResult unused;
    ContestInput input{cells.workload, stress.scene, bed.view(), bed.scenes(), lineup, nullptr, unused};

    const std::uint32_t n = run.config.stress_rays;
    std::optional<RayExam> of_rays;
    std::optional<DepartureExam> of_paths;
    std::map<std::string, std::size_t> batch_of_offset;
    if (stress.of_offsets()) {
        of_paths.emplace(run.backend, bed.judge(), bed.exact(), stress, n, safe_point);
        for (const Contender& c : contenders) {
            const std::string offset = offset_of(c.methods, c.offset);
            if (batch_of_offset.try_emplace(offset, input.batches.size()).second)
                input.batches.push_back(of_paths->batch(offset_policy(offset)));
        }
    } else {
        input.batches.push_back(stress_batch(run.backend, n, stress.ray));
        of_rays.emplace(run.backend, bed.judge(), bed.exact(), input.batches[0], safe_point);
    }
    input.cuda = cuda_workload(run, input, contenders);

    for (std::size_t i = 0; i < contenders.size(); ++i) {
        const Contender& c = contenders[i];
        step("judging " + c.label(), kReference + (1.0 - kReference) * static_cast<double>(i) /
                                                      static_cast<double>(contenders.size()));
        const std::unique_ptr<BatchTracer> tracer = tracer_of(run, input, c);
        const auto paths = [&] {
            Batch& batch = input.batches[batch_of_offset.at(offset_of(c.methods, c.offset))];
            return of_paths->take(*tracer, batch);
        };
        run.results.stability.push_back({c.kind(), c.method(), c.backend, is_default(c), stress.name,
                                         of_paths ? paths() : of_rays->take(*tracer)});
        file.append(run.results.stability.back());
    }
}

}  // namespace ctpbench
