// Studies of methods and of pictures: which cells they have, and what means nothing in them.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "config/cells.h"
#include "config/names.h"

namespace ctpbench {
namespace {

using Names = std::vector<std::string>;

Config study(const std::string& name, const std::string& rest, const KnownNames& known = test_names()) {
    return read_config(JsonDocument::parse("{\"schema_version\": 1, \"experiment\": \"e\", \"study\": \"" +
                                               name + "\"," + rest + "}",
                                           "t.json"),
                       known);
}

Names cells_of(const Config& config) {
    Names names;
    for (const Cell& cell : expand(config, test_names())) names.push_back(cell.name());
    return names;
}

std::string error_of(const std::string& name, const std::string& rest,
                     const KnownNames& known = test_names()) {
    try {
        study(name, rest, known);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        return error.what();
    }
    return "no error";
}

// Every method meets the workloads of its kind; whole bundles meet all; a yardstick forms no rays of its own.
TEST(Study, StabilityHasTheWorkloadsThatEachMethodCanMeet) {
    const Config config = study("stability", R"("matrix": {"triangle_test": ["woop", "pluecker"]},
        "include": [{"sphere_test": "textbook"}, {"offset": "exclude_id"}, {"methods": "paper"},
                    {"strategy": "embree_robust"}])");
    EXPECT_EQ(config.stress, (Names{"edges", "far_spheres", "leaving"}));
    const std::string own = "/0/cpu/embree_robust/own/own";
    EXPECT_EQ(cells_of(config),
              (Names{"edges/0/cpu/ctp/single/watertight/woop", "edges/0/cpu/ctp/single/watertight/pluecker",
                     "far_spheres/0/cpu/ctp/single/watertight/textbook",
                     "leaving/0/cpu/ctp/single/watertight/exclude_id", "edges/0/cpu/ctp/single/paper",
                     "far_spheres/0/cpu/ctp/single/paper", "leaving/0/cpu/ctp/single/paper", "edges" + own,
                     "far_spheres" + own}));
    EXPECT_EQ(study("stability", R"("stress": ["leaving"], "stress_rays": 7)").stress, Names{"leaving"});
}

TEST(Study, AMethodIsKnownByWhatIsExchanged) {
    Contender c{"cpu", "ctp", true, "single", "watertight"};
    EXPECT_EQ(c.kind() + " " + c.method(), "bundle watertight");
    c.triangle_test = "pluecker";
    EXPECT_EQ(c.kind() + " " + c.method(), "triangle pluecker");
    EXPECT_EQ(c.label(), "ctp/pluecker");
    c.box_test = "plain";
    EXPECT_EQ(c.kind() + " " + c.method(), "bundle watertight/pluecker/plain");
    c = {"cpu", "ctp", true, "single", "paper"};
    EXPECT_EQ(c.kind() + " " + c.method(), "bundle paper");
    c.box_test = "padded";
    EXPECT_EQ(c.kind() + " " + c.method(), "bundle paper/padded");
    c = {"cpu", "embree_robust", true, "own", "own"};
    EXPECT_EQ(c.kind() + " " + c.method(), "bundle embree_robust");
}

// Where no ray leaves a surface an offset is nobody's, and what concerns frames makes no cells without them.
TEST(Study, FramesAloneHaveOffsetsLimitsAndRoulette) {
    const std::string matrix = R"("matrix": {"shade": SHADE, "offset": ["bundle", "exclude_id"],
        "bounce_limit": [0, 2], "roulette": [false, true]})";
    const auto with = [&](const std::string& shade) {
        std::string text = matrix;
        return cells_of(study("speed", text.replace(text.find("SHADE"), 5, shade)));
    };
    EXPECT_EQ(with("\"none\""), Names{"smoke/1000/cpu/ctp/single/watertight"});
    const Names frames = with("\"ctp\"");
    ASSERT_EQ(frames.size(), 8u);
    EXPECT_EQ(frames.front(), "smoke/1000/cpu/ctp+ctp/single/watertight");
    EXPECT_EQ(frames.back(), "smoke/1000/cpu/ctp+ctp/single/watertight/exclude_id/limit2/roulette");
}

TEST(Study, RefusesWhatMeansNothing) {
    EXPECT_EQ(error_of("stabilty", "\"matrix\": {}"),
              "t.json:1:51: error: /study: unknown study \"stabilty\"; did you mean \"stability\"? choices: "
              "\"speed\", \"stability\", \"convergence\"");
    EXPECT_EQ(error_of("stability", "\n\"matrix\": {\"scene\": \"smoke\"}"),
              "t.json:2:21: error: /matrix/scene: means nothing in a stability study, whose workloads are "
              "\"stress\"; remove one of the two");
    EXPECT_EQ(error_of("stability", "\n\"stress\": [\"edgse\"]"),
              "t.json:2:12: error: /stress/0: unknown stress workload \"edgse\"; did you mean \"edges\"? "
              "choices: \"edges\", \"far_spheres\", \"leaving\"");
    EXPECT_EQ(error_of("convergence", "\n\"stress_rays\": 5, \"matrix\": {\"shade\": \"ctp\"}"),
              "t.json:2:16: error: /stress_rays: means nothing in this study; remove it");
    EXPECT_EQ(
        error_of("speed", "\n\"stress_rays\": 5"),
        "t.json:2:16: error: /stress_rays: means nothing without table \"pareto\"; remove it, or add that");
    EXPECT_EQ(study("speed", R"("stress_rays": 5, "tables": ["pareto"])").stress_rays, 5u);
    EXPECT_EQ(error_of("speed", "\n\"tables\": [\"pareto\"], \"matrix\": {\"shade\": \"ctp\"}"),
              "t.json:2:12: error: /tables/0: needs recorded rays; add \"none\" to /matrix/shade");
    EXPECT_EQ(error_of("convergence", "\n\"samples\": 100, \"matrix\": {\"shade\": \"ctp\"}"),
              "t.json:2:12: error: /samples: must be a power of two: errors are taken after each doubling");
    EXPECT_EQ(error_of("convergence", "\n\"matrix\": {\"shade\": [\"none\", \"ctp\"]}"),
              "t.json:2:11: error: /matrix: every contender must render; name shade strategies, without "
              "\"none\"");
    EXPECT_EQ(error_of("convergence", "\n\"tables\": [\"table1\"], \"matrix\": {\"shade\": \"ctp\"}"),
              "t.json:2:12: error: /tables/0: belongs to studies of speed; this study writes its own table");
}

TEST(Study, RefusesContendersThatThereAreNot) {
    KnownNames known = test_names();
    known.obstacle = [](const Cell& cell) {
        const Contender& c = *cell.contender;
        return c.triangle_test != of_bundle && c.strategy != "ctp" ? "tests are exchanged in ctp alone" : "";
    };
    EXPECT_EQ(
        error_of("speed", "\n\"matrix\": {\"strategy\": [\"ctp\", \"oop\"], \"triangle_test\": \"pluecker\"}",
                 known),
        "t.json:2:11: error: /matrix: smoke/1000/cpu/oop/single/watertight/pluecker cannot be had: tests are "
        "exchanged in ctp alone");
}

TEST(Study, EchoReadsBackTheSame) {
    for (const Config& config :
         {study("stability", R"("stress": ["edges"], "matrix": {"methods": ["paper", "watertight"]})"),
          study("convergence",
                R"("seeds": 9, "samples": 128, "matrix": {"shade": "ctp", "bounce_limit": 2})")}) {
        EXPECT_EQ(read_config(JsonDocument::parse(to_json(config).dump(), "t.json"), test_names()), config);
    }
}

}  // namespace
}  // namespace ctpbench
