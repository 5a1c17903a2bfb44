// The study of stability, on few rays: the default methods never fail, others do where theory says so.
#include "measure/stability.h"

#include <gtest/gtest.h>

#include <map>

#include "kernels/methods/offset_waechter_binder.h"
#include "oracle/embree.h"
#include "stress/registry.h"
#include "support.h"
#include "wavefront/cpu_tracer.h"

namespace ctpbench {
namespace {

class OwningTracer final : public BatchTracer {
public:
    OwningTracer(CpuBackend& backend, std::unique_ptr<Intersector> intersector, float extent)
        : intersector_(std::move(intersector)), tracer_(backend, *intersector_, extent) {}
    Traced trace(Batch& batch, bool carry_t) override { return tracer_.trace(batch, carry_t); }
    HitStorage& hits() override { return tracer_.hits(); }

private:
    std::unique_ptr<Intersector> intersector_;
    CpuTracer tracer_;
};

CpuBackend& backend() {
    static CpuBackend two(2);
    return two;
}

StabilityMethod bundle(const std::string& name, DepartureExam::Policy policy) {
    return {"bundle",
            name,
            "cpu",
            name == "watertight",
            [name](StressBed& bed) {
                return std::make_unique<OwningTracer>(backend(), make_intersector("ctp", name, bed.layout()),
                                                      bed.view().geometry().extent);
            },
            std::move(policy)};
}
Ray offset_ray(const Departure& d) {
    return {offset_origin(d.point, d.normal), d.direction, test::kInfinity};
}
Ray ray_from_point(const Departure& d) { return {d.point, d.direction, test::kInfinity}; }

std::map<std::string, Accuracy> run(const StabilityMethod& method, std::uint32_t rays) {
    std::map<std::string, Accuracy> found;
    for (const StressInfo& info : stress_workloads())
        run_stability(
            backend(), info, 9, rays, {method}, [](const std::string&, double) {},
            [&](const StabilityRow& row) { found[row.workload] = row.accuracy; });
    return found;
}

TEST(Stability, TheDefaultNeverFails) {
    const auto found = run(bundle("watertight", offset_ray), 8000);
    EXPECT_EQ(found.size(), stress_workloads().size());
    for (const auto& [workload, accuracy] : found) {
        EXPECT_EQ(accuracy.verdict.rays, 8000u);
        EXPECT_EQ(accuracy.failures(), 0u) << workload << ": " << accuracy.verdict.text();
        EXPECT_EQ(accuracy.verdict.reference_wrong, 0u) << workload;
        EXPECT_FALSE(accuracy.p99_scaled_error > 4.0) << workload;
    }
}

TEST(Stability, TheClassicTestLeaksWhereItsAuthorsSayItDoes) {
    const auto found = run(bundle("paper", ray_from_point), 8000);
    const auto share = [&](const char* workload) {
        const Accuracy& a = found.at(workload);
        return static_cast<double>(a.failures()) / static_cast<double>(a.verdict.rays);
    };
    EXPECT_NEAR(share("edges"), 0.110, 0.02);
    EXPECT_NEAR(share("vertices"), 0.110, 0.04);
    EXPECT_GT(share("needles"), 0.0);
    EXPECT_EQ(share("random"), 0.0) << "random rays tell nothing";
    EXPECT_EQ(found.at("edges").verdict.leak, found.at("edges").failures()) << "all of them leaks";
    // Without any offset half of all paths hit what they leave.
    EXPECT_NEAR(share("leave_ball"), 0.5, 0.06);
    EXPECT_NEAR(share("leave_ball_at_1e4"), 0.5, 0.06);
    EXPECT_EQ(found.at("leave_ball").verdict.false_hit, found.at("leave_ball").failures());
}

// A policy that moves too far, as a fixed distance does where walls are thin.
TEST(Stability, AnOffsetLongerThanAGapGoesThroughTheWall) {
    const auto far = [](const Departure& d) {
        return Ray{d.point + 1e-3f * d.normal, d.direction, test::kInfinity};
    };
    std::map<std::string, Accuracy> found;
    for (const StressInfo& info : stress_workloads()) {
        if (info.name != "thin_walls" && info.name != "cross_sphere_x1e-3") continue;
        run_stability(
            backend(), info, 9, 4000, {bundle("watertight", far)}, [](const std::string&, double) {},
            [&](const StabilityRow& row) { found[row.workload] = row.accuracy; });
    }
    EXPECT_NEAR(static_cast<double>(found.at("thin_walls").verdict.wrong_primitive), 2000.0, 150.0);
    EXPECT_GT(found.at("cross_sphere_x1e-3").verdict.missed, 0u);
}

TEST(Stability, EmbreeIsARowLikeAnyOther) {
    if (embree_version().empty()) GTEST_SKIP() << "built without Embree";
    const auto tracer = [](EmbreeMode mode) {
        return [mode](StressBed& bed) {
            return std::make_unique<OwningTracer>(backend(), make_embree(bed.workload().scene, mode, 2),
                                                  0.0f);
        };
    };
    const auto fast = run({"yardstick", "embree_default", "cpu", false, tracer(EmbreeMode::fast)}, 4000);
    const auto robust = run({"yardstick", "embree_robust", "cpu", false, tracer(EmbreeMode::robust)}, 4000);
    EXPECT_EQ(fast.count("leave_ball"), 0u) << "it has no offset of its own";
    EXPECT_GT(fast.at("vertices").verdict.leak, 400u);
    EXPECT_LT(robust.at("vertices").verdict.leak, 40u);
    EXPECT_EQ(robust.at("edges").failures(), 0u);
}

TEST(Stability, KindsMeetWhatConcernsThem) {
    StabilityMethod m{"sphere", "stable", "cpu", true, {}, {}};
    const StressInfo mesh{"", "", kOfTriangles, {}}, ball{"", "", kOfSpheres, {}},
        path{"", "", kOfOffsets, {}};
    EXPECT_TRUE(!m.meets(mesh) && m.meets(ball) && !m.meets(path));
    m.kind = "triangle";
    EXPECT_TRUE(m.meets(mesh) && !m.meets(ball) && !m.meets(path));
    m.kind = "box";
    EXPECT_TRUE(m.meets(mesh) && m.meets(ball) && !m.meets(path));
    m.kind = "bundle", m.policy = offset_ray;
    EXPECT_TRUE(m.meets(mesh) && m.meets(ball) && m.meets(path));
    m.kind = "offset";
    EXPECT_TRUE(!m.meets(mesh) && !m.meets(ball) && m.meets(path));
}

TEST(Stability, CanBeEndedAtASafePoint) {
    struct Enough {};
    int rows = 0;
    EXPECT_THROW(run_stability(
                     backend(), stress_workloads()[0], 1, 1000,
                     {bundle("watertight", offset_ray), bundle("paper", offset_ray)},
                     [&](const std::string&, double) {
                         if (rows > 0) throw Enough{};
                     },
                     [&](const StabilityRow&) { ++rows; }),
                 Enough);
    EXPECT_EQ(rows, 1) << "what was found before is handed out";
}

}  // namespace
}  // namespace ctpbench
