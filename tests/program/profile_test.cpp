// The profile of rays in flight: what it counts must add up.
#include <cmath>

#include "run_program.h"
#include "wavefront/interleaved/isa.h"

namespace ctpbench::test {
namespace {

class Profile : public ProgramTest {};

TEST_F(Profile, CountsWhatEveryRayDoes) {
    write("c.json", R"({"schema_version": 1, "experiment": "x", "width": 480, "height": 400, "bounces": 1,
        "rounds": 1, "batch_rays": 16384, "tables": ["profile"], "reference": "typed_phases", "matrix": {"scene": "smoke",
        "spheres": 40, "strategy": "typed_phases", "traversal": "interleaved"}})");
    for (const std::string& isa : usable_isas()) {
        const Outcome outcome = run("--quiet --config $D/c.json --out $D/" + isa + " --isa " + isa);
        ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
        std::map<std::string, std::map<std::string, double>> per_ray;
        for (const auto& row : read_csv(folder_ / isa / "profile.csv")) {
            EXPECT_EQ(row.at("isa"), isa);
            const double each = std::atof(row.at("cycles_each").c_str());
            const double of_ray = std::stod(row.at("cycles_per_ray"));
            double& times = per_ray[row.at("spheres") + "/" + row.at("bounce")][row.at("phase")];
            times = std::stod(row.at("per_ray"));
            // Looking for packets takes time even where there are none.
            if (times > 0.0) {
                EXPECT_NEAR(each * times, of_ray, 0.01 * of_ray + 0.1) << row.at("phase");
            }
        }
        ASSERT_EQ(per_ray.size(), 2u);
        for (auto& [batch, phases] : per_ray) {
            EXPECT_NEAR(phases["packets"] + phases["ends"], 1.0, 1e-4) << batch;
            EXPECT_GT(phases["nodes"], phases["ends"]) << batch;
            EXPECT_LT(phases["nodes"], 100.0) << batch;
            EXPECT_LE(phases["stacks"], phases["blocks"]) << batch;
        }
        // The camera's rays are alike, those of later bounces are not. Without wide registers no ray is in
        // one.
        const bool packets = isa != ScalarIsa::name;
        EXPECT_EQ(per_ray["40/0"]["packets"] > 0.3, packets);
        EXPECT_LT(per_ray["40/1"]["packets"], 0.1);
    }
}

TEST_F(Profile, NeedsRaysInFlight) {
    write("c.json", R"({"schema_version": 1, "experiment": "x", "tables": ["profile"],
        "matrix": {"scene": "smoke", "strategy": "ctp"}})");
    const Outcome outcome = run("--quiet --config $D/c.json --out $D/r");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.output.find("profiles rays in flight"), std::string::npos) << outcome.output;
}

}  // namespace
}  // namespace ctpbench::test
