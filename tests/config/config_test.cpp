#include "config/config.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/error.h"
#include "base/json_document.h"
#include "config/cells.h"
#include "names.h"

namespace ctpbench {
namespace {

const std::string header = "{\"schema_version\": 1, \"experiment\": \"e\",\n";

// The error of a config that goes on after the header, which is line 1.
std::string error_of(const std::string& rest) {
    try {
        config_of(header + rest);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        return error.what();
    }
    return "no error";
}

std::string read_text(const std::filesystem::path& path) {
    std::ifstream stream(path);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

std::filesystem::path shipped(const std::string& name) {
    return std::filesystem::path(CTPBENCH_SOURCE_DIR) / "configs" / name;
}

TEST(Config, HasADefaultForEverythingButItsNameAndVersion) {
    const Config config = config_of(header + "\"description\": \"d\"}");
    Config expected;
    expected.experiment = "e";
    expected.description = "d";
    expected.tables = {"table2", "table3"};
    EXPECT_EQ(config, expected);
    EXPECT_EQ(expand(config, test_names()).size(), 1u);
}

TEST(Config, ReadsScalarsAndListsOfEveryAxis) {
    const Config config = config_of(header + R"("matrix": {
        "scene": ["a", "b"], "spheres": 0, "sphere_radius": [0.01, 1], "builder": "paper", "backend": ["cpu"],
        "strategy": ["oop", "ctp"], "restart_carries_t": [false, true], "traversal": "interleaved", "methods": "paper",
        "types": "all", "shade": ["sort", "ctp"], "triangle_test": ["bundle", "pluecker"], "sphere_test": "textbook",
        "box_test": "plain", "offset": "exclude_id", "bounce_limit": [0, 2], "roulette": true
    }, "include": [{"threads": [2, 1]}], "batch_bounces": [2, 0], "width": 1, "height": 16384, "bounces": 2, "rounds": 3, "seed": 18446744073709551615, "threads": 4,
    "reference": "ctp", "images": true, "batch_rays": 0, "oracle_rays": 1, "tables": []})");
    EXPECT_EQ(config.matrix, (Axes{{"a", "b"},
                                   {0},
                                   {0.01, 1.0},
                                   {"paper"},
                                   {"cpu"},
                                   {"oop", "ctp"},
                                   {false, true},
                                   {"interleaved"},
                                   {"paper"},
                                   {"all"},
                                   {"sort", "ctp"},
                                   {"isolated"},
                                   {"bundle", "pluecker"},
                                   {"textbook"},
                                   {"plain"},
                                   {"exclude_id"},
                                   {0, 2},
                                   {true},
                                   {0}}));
    EXPECT_EQ(config.include[0].threads, (std::vector<std::uint32_t>{2, 1}));
    EXPECT_EQ(config.batch_bounces, (std::vector<std::uint32_t>{2, 0}));
    EXPECT_EQ(config.height, 16384u);
    EXPECT_EQ(config.seed, 18'446'744'073'709'551'615u);
    EXPECT_EQ(config.reference, "ctp");
    EXPECT_TRUE(config.images);
    EXPECT_TRUE(config.tables.empty());
}

TEST(Config, ReportsEveryMistakeAtOnceInTheOrderOfTheFile) {
    EXPECT_EQ(
        error_of("\"matrix\": {\"shperes\": 1,\n  \"spheres\": [1, -1, 50000001, 1],\n"
                 "  \"strategy\": [\"ctp\", \"opp\"], \"scene\": []},\n"
                 "\"rounds\": 0, \"widht\": 3, \"seed\": 1.5,\n"
                 "\"reference\": \"cpt\", \"tables\": [\"table3\", \"table9\", \"table3\"]}"),
        "t.json:2:12: error: /matrix/shperes: unknown key; did you mean \"spheres\"?\n"
        "t.json:3:18: error: /matrix/spheres/1: must be from 0 to 50000000, found -1\n"
        "t.json:3:22: error: /matrix/spheres/2: must be from 0 to 50000000, found 50000001\n"
        "t.json:3:32: error: /matrix/spheres/3: is here twice; remove one of the two\n"
        "t.json:4:23: error: /matrix/strategy/1: unknown strategy \"opp\"; did you mean \"oop\"? choices: "
        "\"ctp\", \"std_variant\", \"oop\", \"oop_arena\", \"restart\", \"typed_leaves\", \"typed_phases\", "
        "\"embree_robust\", "
        "\"embree_default\", \"while_while\", \"embree_16\", \"embree_16_robust\", \"embree_16_coherent\", "
        "\"embree_16_coherent_robust\", \"embree_stream\", \"embree_stream_robust\", "
        "\"embree_stream_coherent\", \"embree_stream_coherent_robust\"\n"
        "t.json:4:40: error: /matrix/scene: an axis needs a value; give one, or remove the key\n"
        "t.json:5:11: error: /rounds: must be from 1 to 10000, found 0\n"
        "t.json:5:14: error: /widht: unknown key; did you mean \"width\"?\n"
        "t.json:5:34: error: /seed: expected an integer, found 1.5\n"
        "t.json:6:14: error: /reference: unknown strategy \"cpt\"; did you mean \"ctp\"? choices: "
        "\"ctp\", \"std_variant\", \"oop\", \"oop_arena\", \"restart\", \"typed_leaves\", \"typed_phases\", "
        "\"embree_robust\", "
        "\"embree_default\", \"while_while\", \"embree_16\", \"embree_16_robust\", \"embree_16_coherent\", "
        "\"embree_16_coherent_robust\", \"embree_stream\", \"embree_stream_robust\", "
        "\"embree_stream_coherent\", \"embree_stream_coherent_robust\", \"sort\", \"sort_restored\", "
        "\"queues\"\n"
        "t.json:6:42: error: /tables/1: unknown table \"table9\"; did you mean \"table2\"? choices: "
        "\"table2\", \"table3\", \"table1\", \"figure4\", \"pareto\", \"narrowing\", \"types\", \"peers\", "
        "\"growth\", "
        "\"profile\"\n"
        "t.json:6:52: error: /tables/2: is here twice; remove one of the two");
}

TEST(Config, RefusesImpossibleAxes) {
    EXPECT_EQ(error_of("\"matrix\": {\"sphere_radius\": [0.1, 0]}}"),
              "t.json:2:35: error: /matrix/sphere_radius/1: must be greater than 0 and at most 10, found 0");
    EXPECT_EQ(error_of("\"matrix\": {\"backend\": \"hip\"}}"),
              "t.json:2:23: error: /matrix/backend: unknown backend \"hip\"; choices: \"cpu\", \"cuda\"");
    EXPECT_EQ(error_of("\"matrix\": {\"scene\": \"x/y\"}}"),
              "t.json:2:21: error: /matrix/scene: give a scene file's name without folder and \".json\"; "
              "--scene-dir adds folders");
    EXPECT_EQ(error_of("\"matrix\": {\"restart_carries_t\": [true, \"no\"]}}"),
              "t.json:2:40: error: /matrix/restart_carries_t/1: expected true or false, found \"no\"");
    EXPECT_EQ(error_of("\"matrix\": []}"),
              "t.json:2:11: error: /matrix: expected an object, found a list of 0");
    std::string many;
    for (int i = 0; i < 400; ++i) many += (i ? "," : "") + std::to_string(i);
    std::string names;
    for (int i = 0; i < 400; ++i) names += (i ? ",\"s" : "\"s") + std::to_string(i) + "\"";
    EXPECT_EQ(error_of("\"matrix\": {\"spheres\": [" + many + "], \"scene\": [" + names + "]}}"),
              "t.json:2:11: error: /matrix: makes more than 100000 cells; split the experiment");
}

// What each entry makes alone is little; multiplied, it would fill any memory, or take hours.
TEST(Config, BoundsEntriesAndWhatTheyMakeTogether) {
    const auto list = [](const std::string& entry, std::size_t times) {
        std::string text = "[" + entry;
        for (std::size_t i = 1; i < times; ++i) text += ", " + entry;
        return text + "]";
    };
    EXPECT_EQ(error_of("\"exclude\": " + list("{\"scene\": \"x\"}", 1001) + "}"),
              "t.json:2:12: error: /exclude: more than 1000 entries; split the experiment");
    EXPECT_EQ(error_of("\"include\": " + list("{}", 1001) + "}"),
              "t.json:2:12: error: /include: more than 1000 entries; split the experiment");
    std::string spheres = "0";
    for (int i = 1; i <= 1000; ++i) spheres += ", " + std::to_string(i);
    EXPECT_EQ(
        error_of("\"matrix\": {\"spheres\": [" + spheres + "]}}"),
        "t.json:2:23: error: /matrix/spheres: more than 1000 values along one axis; split the experiment");
    // A hundred times a thousand cells, and the matrix' own one.
    spheres.erase(spheres.rfind(','));
    std::string scenes;
    for (int i = 0; i < 100; ++i)
        scenes += (i ? ", {\"scene\": \"s" : "{\"scene\": \"s") + std::to_string(i) + "\", \"spheres\": [" +
                  spheres + "]}";
    EXPECT_NE(error_of("\"include\": [" + scenes + "]}").find("/include/99: makes more than 100000 cells"),
              std::string::npos);
}

TEST(Config, RefusesMatricesThatCannotBeRun) {
    EXPECT_EQ(error_of("\"exclude\": [{\"scene\": \"smoke\"}]}"),
              "t.json:2:12: error: /exclude: leaves nothing of the matrix; exclude less");
    EXPECT_EQ(error_of("\"exclude\": [{}]}"),
              "t.json:2:13: error: /exclude/0: would exclude everything; name an axis and its values");
    EXPECT_EQ(error_of("\"exclude\": [{\"strategy\": \"cpt\"}, {\"scene\": []}, 3]}").substr(0, 53),
              "t.json:2:26: error: /exclude/0/strategy: unknown stra");
    EXPECT_EQ(error_of("\"include\": [{\"scene\": \"x\"}, {}]}"),
              "t.json:2:29: error: /include/1: smoke/1000/cpu/ctp/single/watertight is there already; remove "
              "it here");
    EXPECT_EQ(error_of("\"reference\": \"oop\"}"),
              "t.json:2:14: error: /reference: \"oop\" is not among the strategies measured; add it to "
              "/matrix/strategy or refer to another");
    EXPECT_EQ(error_of("\"matrix\": {\"strategy\": \"oop\"}}").substr(0, 34),
              "t.json:1:1: error: /reference: \"ct");
}

TEST(Config, ThatMeasuresNothingHasNoContenders) {
    EXPECT_EQ(error_of("\"measure\": false, \"matrix\": {\"builder\": \"paper\"}}"), "no error");
    EXPECT_EQ(
        error_of("\"measure\": false, \"matrix\": {\"strategy\": \"ctp\"}, \"tables\": [\"table3\"]}"),
        "t.json:2:42: error: /matrix/strategy: means nothing as \"measure\" is false; remove one of the two\n"
        "t.json:2:61: error: /tables/0: needs measurements, but \"measure\" is false; change one of the two");
    EXPECT_EQ(config_of(header + "\"measure\": false}").tables, std::vector<std::string>{"table2"});
}

TEST(Config, ChecksItsHeader) {
    const auto error = [](const std::string& text) -> std::string {
        try {
            config_of(text);
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_EQ(error("{}"),
              "t.json:1:1: error: \"schema_version\" is missing; add it\n"
              "t.json:1:1: error: \"experiment\" is missing; add it");
    EXPECT_EQ(error("{\"schema_version\": 2, \"experiment\": \"e\"}"),
              "t.json:1:20: error: /schema_version: this program reads version 1, found 2");
    for (const char* name : {"", "a/b", "..", "a b"}) {
        EXPECT_TRUE(error("{\"schema_version\": 1, \"experiment\": \"" + std::string(name) + "\"}")
                        .starts_with("t.json:1:37: error: /experiment: names files"))
            << name;
    }
    EXPECT_EQ(error("{\"$schema\": \"x.json\", \"schema_version\": 1, \"experiment\": \"a-1.b_C\"}"),
              "no error");
}

TEST(Config, CutShortAnywhereIsAnErrorWithAPlace) {
    const std::string text = read_text(shipped("table3.json"));
    const std::size_t end = text.rfind('}');
    ASSERT_NE(end, std::string::npos);
    for (std::size_t length = 0; length <= end; ++length) {
        try {
            config_of(text.substr(0, length));
            ADD_FAILURE() << "accepted " << length << " bytes";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::usage);
            std::size_t line = 0, column = 0;
            EXPECT_EQ(std::sscanf(error.what(), "t.json:%zu:%zu: error: ", &line, &column), 2)
                << error.what();
            EXPECT_GE(line, 1u);
            EXPECT_GE(column, 1u);
        }
    }
}

TEST(Config, AnyByteChangedNeverCrashes) {
    const std::string text = read_text(shipped("smoke.json"));
    for (std::size_t i = 0; i < text.size(); ++i) {
        for (const char c : {'\0', '"', '{', '}', '[', ']', ',', '/', '*', '\\', '9', '-', '\n', '\xC3'}) {
            std::string changed = text;
            changed[i] = c;
            try {
                config_of(changed);
            } catch (const Error& error) {
                EXPECT_TRUE(std::string(error.what()).starts_with("t.json:")) << error.what();
            }
        }
    }
}

// Frames are measured beside intersections or instead of them; what needs them says so.
TEST(Config, RendersWhereAShadeStrategyIsNamed) {
    const Config both = config_of(header + R"("matrix": {"strategy": ["ctp", "embree_robust"],
        "shade": ["none", "ctp", "sort"]}})");
    EXPECT_EQ(both.tables, (std::vector<std::string>{"table2", "table3", "table1", "figure4"}));
    std::vector<std::string> labels;
    for (const Cell& cell : expand(both, test_names())) labels.push_back(cell.contender->label());
    EXPECT_EQ(labels, (std::vector<std::string>{"ctp", "ctp+ctp", "ctp+sort", "embree_robust"}))
        << "a yardstick only intersects";
    const Config frames = config_of(header + R"("matrix": {"strategy": "restart", "shade": "ctp"}})");
    EXPECT_EQ(frames.tables, (std::vector<std::string>{"table2", "table1", "figure4"}));
    EXPECT_EQ(expand(frames, test_names())[0].name(), "smoke/1000/cpu/restart+ctp/single/watertight");

    EXPECT_EQ(error_of("\"images\": true, \"tables\": [\"figure4\"]}"),
              "t.json:2:11: error: /images: needs rendered frames; name shade strategies in /matrix/shade\n"
              "t.json:2:28: error: /tables/0: needs rendered frames; name shade strategies in /matrix/shade");
    EXPECT_EQ(error_of("\"matrix\": {\"strategy\": \"oop\", \"shade\": \"sort\"},\n\"reference\": \"oop\"}"),
              "t.json:3:14: error: /reference: \"oop\" is not among the strategies measured; add it to "
              "/matrix/shade or refer to another");
    EXPECT_EQ(
        error_of("\"matrix\": {\"shade\": \"srt\"}}"),
        "t.json:2:21: error: /matrix/shade: unknown shade \"srt\"; did you mean \"sort\"? choices: \"none\", "
        "\"ctp\", \"std_variant\", \"oop\", \"oop_arena\", \"sort\", \"sort_restored\", \"queues\"");
}

// Bounces are those of the frame; threads are for recorded rays on the CPU.
TEST(Config, RefusesBouncesAndThreadsThatMeanNothing) {
    EXPECT_EQ(error_of("\"bounces\": 4, \"batch_bounces\": [0, 5, 4, 4]}"),
              "t.json:2:36: error: /batch_bounces/1: must be from 0 to 4, found 5\n"
              "t.json:2:42: error: /batch_bounces/3: is here twice; remove one of the two");
    EXPECT_EQ(
        error_of("\"batch_bounces\": []}"),
        "t.json:2:18: error: /batch_bounces: leaves no rays; name bounces, or remove the key for all of "
        "them");
    EXPECT_EQ(error_of("\"matrix\": {\"shade\": \"ctp\"}, \"batch_bounces\": 1}"),
              "t.json:2:46: error: /batch_bounces: needs recorded rays; add \"none\" to /matrix/shade");
    EXPECT_EQ(error_of("\"measure\": false, \"batch_bounces\": 1}"),
              "t.json:2:36: error: /batch_bounces: means nothing as \"measure\" is false; remove one of the "
              "two");
    EXPECT_EQ(error_of("\"study\": \"stability\", \"batch_bounces\": 1}"),
              "t.json:2:40: error: /batch_bounces: belongs to studies of speed; remove it");
    EXPECT_EQ(error_of("\"matrix\": {\"threads\": [1, 1025]}}"),
              "t.json:2:27: error: /matrix/threads/1: must be from 0 to 1024, found 1025");
    EXPECT_EQ(error_of("\"include\": [{\"shade\": [\"none\", \"ctp\"], \"threads\": [1, 2]}]}"),
              "t.json:2:51: error: /include/0/threads: frames are rendered by the run's own threads; name "
              "shade strategies in an entry of /include, without threads");
    EXPECT_EQ(
        error_of("\"matrix\": {\"backend\": \"cuda\", \"threads\": 1}}"),
        "t.json:2:42: error: /matrix/threads: concerns the CPU alone; add backend \"cpu\", or remove it");
    EXPECT_EQ(error_of("\"study\": \"stability\", \"matrix\": {\"threads\": 1}}"),
              "t.json:2:45: error: /matrix/threads: means nothing in a stability study, whose workloads are "
              "\"stress\"; remove one of the two");
}

TEST(Config, PeersNeedIntersect1BesideThem) {
    EXPECT_EQ(
        error_of("\"tables\": [\"peers\"]}"),
        "t.json:2:12: error: /tables/0: compares with rtcIntersect1 on the CPU; name \"embree_default\" "
        "and others in /matrix/strategy");
    EXPECT_EQ(error_of("\"matrix\": {\"strategy\": [\"ctp\", \"embree_default\"]}, \"tables\": [\"peers\"]}"),
              "no error");
}

TEST(Config, ReadsWhenRoundsStop) {
    const Config config = config_of(header + "\"min_time\": 2, \"max_noise\": 0.01, \"timeout\": 60.5}");
    EXPECT_EQ(config.min_time, 2.0);
    EXPECT_EQ(config.max_noise, 0.01);
    EXPECT_EQ(config.timeout, 60.5);
    EXPECT_EQ(read_config(JsonDocument::parse(to_json(config).dump(), "echo"), test_names()), config);
    EXPECT_NE(error_of("\"max_noise\": 0.01}").find("give a timeout too"), std::string::npos);
    EXPECT_NE(error_of("\"min_time\": 9, \"timeout\": 5}").find("is shorter than min_time"),
              std::string::npos);
    EXPECT_NE(error_of("\"study\": \"stability\", \"min_time\": 9}").find("studies of speed"),
              std::string::npos);
}

TEST(Config, EchoReadsBackTheSame) {
    std::vector<Config> configs = {
        config_of(header + R"("matrix": {"strategy": ["ctp", "restart"],
        "spheres": [0, 7], "sphere_radius": [0.1, 0.3], "restart_carries_t": [false]},
        "exclude": [{"spheres": 0, "strategy": ["restart"]}], "include": [{"scene": "x"}, {"spheres": [1, 2]}],
        "seed": 18446744073709551615, "batch_bounces": [3, 0], "tables": []})"),
        config_of(header + R"("matrix": {"shade": ["none", "ctp"]}, "images": true})")};
    for (const auto& entry : std::filesystem::directory_iterator(shipped(""))) {
        if (entry.is_regular_file()) configs.push_back(load_config(entry.path(), {}, test_names()));
    }
    for (const Config& config : configs) {
        const nlohmann::json echo = to_json(config);
        EXPECT_EQ(config_of(echo.dump()), config) << echo.dump(2);
        EXPECT_EQ(to_json(config_of(echo.dump())), echo);
    }
}

TEST(Config, EchoHasEveryDefault) {
    const nlohmann::json echo = to_json(config_of(header + "\"width\": 8}"));
    EXPECT_EQ(echo["width"], 8);
    EXPECT_EQ(echo["height"], 1024);
    EXPECT_EQ(echo["matrix"]["methods"], nlohmann::json::array({"watertight"}));
    EXPECT_EQ(echo["matrix"]["shade"], nlohmann::json::array({"none"}));
    EXPECT_EQ(echo["matrix"]["threads"], nlohmann::json::array({0}));
    EXPECT_EQ(echo["matrix"].size(), 19u);
}

TEST(Config, EditsApplyBeforeReading) {
    const auto load = [](const std::vector<ConfigEdit>& edits) {
        return load_config(shipped("table3.json"), edits, test_names());
    };
    const Config config = load({{"/matrix/spheres=[5]", ""},
                                {"/matrix/scene=sponza", ""},
                                {"/rounds=2", ""},
                                {"/rounds=3", "--rounds 3"}});
    EXPECT_EQ(config.matrix.spheres, std::vector<std::uint32_t>{5});
    EXPECT_EQ(config.matrix.scene, std::vector<std::string>{"sponza"});
    EXPECT_EQ(config.rounds, 3u);
    try {
        load({{"/rounds=0", "--rounds 0"}, {"/matrix/spheres=many", ""}, {"/matirx=1", ""}});
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_STREQ(
            error.what(),
            "--rounds 0: error: /rounds: must be from 1 to 10000, found 0\n"
            "--set /matrix/spheres=many: error: /matrix/spheres: expected an integer, found \"many\"\n"
            "--set /matirx=1: error: /matirx: unknown key; did you mean \"matrix\"?");
    }
}

TEST(Config, ShippedConfigsHaveTheirCells) {
    const auto cells = [](const std::string& name) {
        return expand(load_config(shipped(name), {}, test_names()), test_names()).size();
    };
    EXPECT_EQ(cells("smoke.json"), 7u + 8 + 2 + 7);  // single, interleaved, Embree's; shade strategies
    EXPECT_EQ(cells("table2.json"), 2u * 4 * 2);     // scenes, sphere counts, builders
    EXPECT_EQ(cells("table3.json"), 2u * 3 * (7 + 8 + 2));
    EXPECT_EQ(cells("triangles.json"), 3u * (4 + 4 + 2));
    EXPECT_EQ(cells("table1.json"), 2u * 7);
    EXPECT_EQ(cells("reorder.json"), 3u);
    EXPECT_EQ(cells("figure4.json"), 3u * 5);
    EXPECT_EQ(cells("narrowing.json"), 7u * 2 * (6 + 7));  // scenes, all and scene, intersect and shade
    EXPECT_EQ(cells("types.json"), 19u * (6 + 7));
    EXPECT_EQ(cells("peers.json"), 3u * (2 + 10) * 2);  // scenes, ours and Embree's, threads
    EXPECT_EQ(cells("profile.json"), 3u * 2);
    EXPECT_EQ(cells("growth.json"), 4u * (2 + 2));
    EXPECT_EQ(cells("figure1.json"), 2u);
    EXPECT_EQ(cells("figure3.json"), 2u);
}

}  // namespace
}  // namespace ctpbench
