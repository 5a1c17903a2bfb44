// The study of stability, on few rays: the default methods never fail, others do where theory says so.
#include "measure/exam.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "measure/stress_bed.h"
#include "oracle/embree.h"
#include "stress/registry.h"
#include "support.h"
#include "wavefront/cpu_tracer.h"
#include "wavefront/interleaved/intersector.h"
#include "wavefront/interleaved/isa.h"

namespace ctpbench {
namespace {

CpuBackend& backend() {
    static CpuBackend two(2);
    return two;
}

using Make = std::function<std::unique_ptr<Intersector>(StressBed&)>;

Make bundle(const std::string& name) {
    return [name](StressBed& bed) { return make_intersector("ctp", name, bed.layout()); };
}
Make embree(EmbreeMode mode) {
    return [mode](StressBed& bed) { return make_embree(bed.workload().scene, mode, 2); };
}

Accuracy judge(const std::string& workload, const Make& make, const DepartureExam::Policy& policy,
               std::uint32_t rays) {
    StressBed bed(backend(), make_stress(workload, 9));
    const std::unique_ptr<Intersector> intersector = make(bed);
    CpuTracer tracer(backend(), *intersector, bed.view().geometry().extent);
    if (bed.workload().of_offsets()) {
        const DepartureExam exam(backend(), bed.judge(), bed.exact(), bed.workload(), rays, [] {});
        Batch batch = exam.batch(policy);
        return exam.take(tracer, batch);
    }
    Batch batch = stress_batch(backend(), rays, bed.workload().ray);
    RayExam exam(backend(), bed.judge(), bed.exact(), batch, [] {});
    return exam.take(tracer);
}

// Workloads of offsets only if there is a policy.
std::map<std::string, Accuracy> judge_all(const Make& make, const DepartureExam::Policy& policy,
                                          std::uint32_t rays) {
    std::map<std::string, Accuracy> found;
    for (const StressInfo& info : stress_workloads())
        if (policy || !info.kinds.offset) found[info.name] = judge(info.name, make, policy, rays);
    return found;
}

double share(const Accuracy& a) {
    return static_cast<double>(a.failures()) / static_cast<double>(a.verdict.rays);
}

TEST(Stability, TheDefaultNeverFails) {
    for (const auto& [workload, accuracy] :
         judge_all(bundle("watertight"), offset_policy("waechter_binder"), 8000)) {
        EXPECT_EQ(accuracy.verdict.rays, 8000u);
        EXPECT_EQ(accuracy.failures(), 0u) << workload << ": " << accuracy.verdict.text();
        EXPECT_EQ(accuracy.verdict.reference_wrong, 0u) << workload;
        EXPECT_FALSE(accuracy.p99_scaled_error > 4.0) << workload;
    }
}

// All that is said of the default methods holds for rays in flight too: their hits are the same, bit for bit.
TEST(Stability, RaysInFlightHitTheSame) {
    for (const StressInfo& info : stress_workloads()) {
        StressBed bed(backend(), make_stress(info.name, 9));
        Batch batch = bed.workload().of_offsets()
                          ? DepartureExam(backend(), bed.judge(), bed.exact(), bed.workload(), 3000, [] {})
                                .batch(offset_policy("waechter_binder"))
                          : stress_batch(backend(), 3000, bed.workload().ray);
        const auto hash_of = [&](const std::unique_ptr<Intersector>& intersector) {
            return CpuTracer(backend(), *intersector, bed.view().geometry().extent).trace(batch, true).hash;
        };
        const std::uint64_t expected = hash_of(make_intersector("ctp", "watertight", bed.layout()));
        for (const std::string& isa : usable_isas())
            for (const StrategyInfo& s : interleaved_strategies())
                EXPECT_EQ(hash_of(make_interleaved(backend(), s.name, bed.layout(), isa)), expected)
                    << info.name << ", " << s.name << ", " << isa;
    }
}

TEST(Stability, TheClassicTestLeaksAtEdgesAndVertices) {
    const auto leaks = [](const char* workload) {
        const Accuracy a = judge(workload, bundle("fast"), {}, 8000);
        EXPECT_EQ(a.verdict.leak, a.failures()) << workload << ": " << a.verdict.text();
        return share(a);
    };
    EXPECT_NEAR(leaks("edges"), 0.110, 0.02);
    EXPECT_NEAR(leaks("vertices"), 0.110, 0.04);
    EXPECT_GT(leaks("needles"), 0.0);
    EXPECT_EQ(leaks("random"), 0.0) << "random rays tell nothing";
}

TEST(Stability, TheTextbookSphereIsLostFromAfar) {
    const auto failing = [](const char* workload) {
        return share(judge(workload, bundle("paper"), {}, 4000));
    };
    EXPECT_GT(failing("sphere_at_1e4"), 0.2);
    EXPECT_GT(failing("sphere_passed_at_1e4"), 0.5);
    EXPECT_EQ(failing("sphere_inside"), 0.0);
}

TEST(Stability, OffsetsFailWhereTheyAreTooShortOrTooLong) {
    const auto judged = [](const char* workload, const char* offset) {
        return judge(workload, bundle("watertight"), offset_policy(offset), 4000);
    };
    // Without any offset, and without leaving out the start, half of all paths hit what they leave.
    EXPECT_NEAR(share(judged("leave_ball", "exclude_id")), 0.5, 0.06);
    EXPECT_EQ(judged("leave_ball", "constant_epsilon").failures(), 0u);
    const Accuracy far_out = judged("leave_ball_at_1e4", "constant_epsilon");
    EXPECT_NEAR(share(far_out), 0.5, 0.06);
    EXPECT_EQ(far_out.verdict.false_hit, far_out.failures());
    const Accuracy tiny = judged("cross_ball_x1e-3", "constant_epsilon");
    EXPECT_GT(tiny.verdict.missed, 0u);
    EXPECT_EQ(tiny.verdict.missed, tiny.failures());
    const Accuracy walls = judged("thin_walls", "constant_epsilon");
    EXPECT_GT(share(walls), 0.1);
    EXPECT_EQ(walls.verdict.wrong_primitive, walls.failures());
}

TEST(Stability, EmbreeIsJudgedLikeAnyOther) {
    if (embree_version().empty()) GTEST_SKIP() << "built without Embree";
    const auto fast = judge_all(embree(EmbreeMode::fast), {}, 2000);
    const auto robust = judge_all(embree(EmbreeMode::robust), {}, 2000);
    EXPECT_NEAR(share(fast.at("vertices")), 0.19, 0.03);
    EXPECT_LT(share(robust.at("vertices")), 0.01);
    EXPECT_EQ(robust.at("edges").failures(), 0u);
}

TEST(Stability, CanBeEndedAtASafePoint) {
    struct Enough {};
    StressBed bed(backend(), make_stress("edges", 1));
    Batch batch = stress_batch(backend(), 200000, bed.workload().ray);
    int points = 0;
    const auto at_second = [&] {
        if (++points == 2) throw Enough{};
    };
    EXPECT_THROW(RayExam(backend(), bed.judge(), bed.exact(), batch, at_second), Enough);
}

}  // namespace
}  // namespace ctpbench
