// The study of convergence, run as a user would: what its tables say of a small scene.
#include <cmath>

#include "run_program.h"

namespace ctpbench::test {
namespace {

class ConvergenceRun : public ProgramTest {
protected:
    // Pictures of the smoke scene, so small that a second is enough.
    void write_config(const std::string& more) const {
        write("c.json",
              R"({"schema_version": 1, "study": "convergence", "experiment": "c", "width": 24, "height": 24,
                  "bounces": 16, "reference_samples": 1024,
                  "matrix": {"scene": "smoke", "spheres": 20, "strategy": "ctp", "shade": ["ctp", "sort"]},
                  "include": [{"scene": "smoke", "spheres": 20, "strategy": "restart", "shade": "ctp"},
                              {"scene": "smoke", "spheres": 20, "shade": "ctp", "bounce_limit": 1}])" +
                  more + "}");
    }
};

TEST_F(ConvergenceRun, FindsTheSlopeAndThePlateau) {
    write_config(R"(, "samples": 64, "seeds": 8)");
    const Outcome outcome = run("--quiet --config $D/c.json --out $D/r");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;

    const auto fits = read_csv(folder_ / "r/convergence_fits.csv");
    ASSERT_EQ(fits.size(), 4u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(std::stod(fits[i].at("slope")), -0.5, 0.03) << i;
        EXPECT_LT(std::stod(fits[i].at("lo_bias")), 0.0) << i;
        EXPECT_GT(std::stod(fits[i].at("hi_bias")), 0.0) << i;
        EXPECT_EQ(fits[i].at("bias_relmse"), fits[0].at("bias_relmse"));  // the same pictures
    }
    EXPECT_EQ(fits[3].at("bounces"), "1");
    EXPECT_GT(std::stod(fits[3].at("lo_slope")), -0.45);
    const double plateau = std::stod(fits[3].at("bias_relmse"));
    EXPECT_GT(std::stod(fits[3].at("lo_bias")), 0.5 * plateau);

    const auto points = read_csv(folder_ / "r/convergence.csv");
    ASSERT_EQ(points.size(), 4u * 7u);
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(points[i].at("samples"), std::to_string(1 << i % 7));
        EXPECT_EQ(points[i].at("seeds"), "8");
        EXPECT_EQ(points[i].at("offset"), "waechter_binder");
        if (i % 7 > 0) {
            EXPECT_GT(std::stod(points[i].at("seconds")), std::stod(points[i - 1].at("seconds")));
            EXPECT_LT(std::stod(points[i].at("relmse")), std::stod(points[i - 1].at("relmse")));
        }
        if (i < 7) {
            EXPECT_EQ(points[i].at("relmse"), points[i + 7].at("relmse"));
            EXPECT_EQ(points[i].at("relmse"), points[i + 14].at("relmse"));
        }
    }
    // The curve ends at the plateau: what is above it falls as one over the samples.
    const double last = std::stod(points[27].at("relmse")), half = std::stod(points[26].at("relmse"));
    EXPECT_NEAR((half - plateau) / (last - plateau), 2.0, 0.3);
}

TEST_F(ConvergenceRun, KeepsTheSeedsThatWereFinished) {
    write_config(R"(, "samples": 64, "seeds": 1000)");
    // Its progress says when the third seed begins.
    const Outcome outcome = run_shell("D='" + folder_.string() +
                                      "'; \"$P\" --config $D/c.json --out $D/r >$D/log 2>&1 & pid=$!; "
                                      "for i in $(seq 600); do grep -q 'seed 3 of' $D/log && break; "
                                      "sleep 0.1; done; kill -INT $pid; wait $pid");
    EXPECT_EQ(outcome.exit_code, 130) << read(folder_ / "log");
    const auto points = read_csv(folder_ / "r/convergence.csv");
    ASSERT_EQ(points.size(), 4u * 7u);
    const int seeds = std::stoi(points[0].at("seeds"));
    EXPECT_GE(seeds, 2);
    for (const auto& point : points) EXPECT_EQ(point.at("seeds"), std::to_string(seeds));
    EXPECT_EQ(read_csv(folder_ / "r/convergence_fits.csv").size(), 4u);
    EXPECT_NE(read(folder_ / "r/meta.json").find("\"state\": \"interrupted\""), std::string::npos);
}

}  // namespace
}  // namespace ctpbench::test
