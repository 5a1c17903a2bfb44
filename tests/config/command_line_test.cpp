#include "config/command_line.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace ctpbench {
namespace {

using Action = CommandLine::Action;

CommandLine parse(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), "ctpbench");
    return parse_command_line(static_cast<int>(arguments.size()), arguments.data());
}

std::string error_of(const std::vector<const char*>& arguments) {
    try {
        parse(arguments);
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        return error.what();
    }
    return "no error";
}

TEST(CommandLine, ABareConfigMeansRun) {
    const CommandLine line = parse({"--config", "c.json"});
    EXPECT_EQ(line.action, Action::run);
    EXPECT_EQ(line.config, "c.json");
    EXPECT_TRUE(line.out.empty());
    EXPECT_TRUE(line.edits.empty());
    EXPECT_EQ(line.scenes, SceneChoice::auto_);
    EXPECT_EQ(parse({"run", "--config", "c.json"}).config, "c.json");
    EXPECT_EQ(parse({"--config", "c.json", "run", "--out", "o"}).out, "o");
}

TEST(CommandLine, ReadsEveryRunOption) {
    const CommandLine line = parse({"--config=c.json",
                                    "--out",
                                    "o",
                                    "--scene-dir",
                                    "s1",
                                    "--scene-dir",
                                    "s2",
                                    "--scenes",
                                    "stand-in",
                                    "--threads",
                                    "2",
                                    "--rounds",
                                    "5",
                                    "--seed",
                                    "18446744073709551615",
                                    "--filter",
                                    "a/b",
                                    "--set",
                                    "/a=1",
                                    "--set",
                                    "/m/s=[1,2]",
                                    "--quiet",
                                    "--dry-run"});
    EXPECT_EQ(line.action, Action::dry_run);
    EXPECT_EQ(line.out, "o");
    EXPECT_EQ(line.scene_dirs, (std::vector<std::filesystem::path>{"s1", "s2"}));
    EXPECT_EQ(line.scenes, SceneChoice::stand_in);
    EXPECT_EQ(line.threads, 2u);
    EXPECT_EQ(line.seed, 18'446'744'073'709'551'615u);
    EXPECT_EQ(line.filter, "a/b");
    EXPECT_TRUE(line.quiet);
    std::vector<std::string> edits;
    for (const ConfigEdit& edit : line.edits) edits.push_back(edit.assignment + " by " + edit.option);
    EXPECT_EQ(edits, (std::vector<std::string>{"/a=1 by --set /a=1", "/m/s=[1,2] by --set /m/s=[1,2]",
                                               "/threads=2 by --threads 2", "/rounds=5 by --rounds 5",
                                               "/seed=18446744073709551615 by --seed 18446744073709551615"}));
}

TEST(CommandLine, ReadsTheRenderSubcommand) {
    const CommandLine line =
        parse({"render",      "conference", "--image",   "i.png", "--width",   "64", "--height",   "32",
               "--spheres",   "7",          "--samples", "5",     "--bounces", "4",  "--exposure", "1.5",
               "--scene-dir", "s",          "--scenes",  "real",  "--seed",    "3"});
    EXPECT_EQ(line.action, Action::render);
    EXPECT_EQ(line.scene, "conference");
    EXPECT_EQ(line.image, "i.png");
    EXPECT_EQ(line.width, 64u);
    EXPECT_EQ(line.height, 32u);
    EXPECT_EQ(line.spheres, 7u);
    EXPECT_EQ(line.samples, 5u);
    EXPECT_EQ(line.bounces, 4u);
    EXPECT_EQ(line.exposure, 1.5f);
    EXPECT_EQ(line.scene_dirs, std::vector<std::filesystem::path>{"s"});
    EXPECT_EQ(line.scenes, SceneChoice::real);
    EXPECT_EQ(line.seed, 3u);
    EXPECT_EQ(parse({"--scene-dir", "s", "render", "conference", "--image", "i.png"}).scene, "conference");
}

TEST(CommandLine, StopRulesAreEditsOfTheConfig) {
    const CommandLine line =
        parse({"--config", "c", "--timeout", "60", "--max-noise", "0.015", "--min-time", "2.5"});
    std::vector<std::string> edits;
    for (const ConfigEdit& edit : line.edits) edits.push_back(edit.assignment + " by " + edit.option);
    EXPECT_EQ(edits, (std::vector<std::string>{"/min_time=2.5 by --min-time 2.5",
                                               "/max_noise=0.015 by --max-noise 0.015",
                                               "/timeout=60 by --timeout 60"}));
    EXPECT_NE(error_of({"--config", "c", "--min-time", "-1"}).find("--min-time"), std::string::npos);
    EXPECT_NE(error_of({"--config", "c", "--max-noise", "2"}).find("--max-noise"), std::string::npos);
}

TEST(CommandLine, ReadsTheCompareSubcommand) {
    const CommandLine line = parse({"compare", "a", "b", "--fail-ratio", "0.8", "--strict"});
    EXPECT_EQ(line.action, Action::compare);
    EXPECT_EQ(line.base, "a");
    EXPECT_EQ(line.fresh, "b");
    EXPECT_EQ(line.fail_ratio, 0.8);
    EXPECT_TRUE(line.strict);
    EXPECT_EQ(parse({"compare", "a", "b"}).fail_ratio, 0.9);
    EXPECT_FALSE(parse({"compare", "a", "b"}).strict);
    EXPECT_NE(parse({"compare", "--help"}).help_text.find("--fail-ratio"), std::string::npos);
    EXPECT_NE(error_of({"compare", "a"}).find("NEW"), std::string::npos);
    EXPECT_NE(error_of({"compare", "a", "b", "--fail-ratio", "1.5"}).find("--fail-ratio"), std::string::npos);
    EXPECT_EQ(error_of({"--quiet", "compare", "a", "b"}),
              "ctpbench: error: --quiet means nothing to ctpbench compare; see ctpbench compare --help");
    EXPECT_EQ(error_of({"compare", "a", "b", "--strickt"}),
              "ctpbench: error: unknown argument --strickt; did you mean --strict?");
}

TEST(CommandLine, OtherActions) {
    EXPECT_EQ(parse({"--version"}).action, Action::version);
    EXPECT_EQ(parse({"--list"}).action, Action::list);
    const CommandLine help = parse({"--help"});
    EXPECT_EQ(help.action, Action::help);
    for (const char* part :
         {"--config", "--set", "--scene-dir", "Examples:", "Exit codes:", "130 interrupted", "render"}) {
        EXPECT_NE(help.help_text.find(part), std::string::npos) << part << "\n" << help.help_text;
    }
    EXPECT_NE(parse({"render", "--help"}).help_text.find("--image"), std::string::npos);
}

TEST(CommandLine, ErrorsHaveAHint) {
    EXPECT_EQ(error_of({}),
              "ctpbench: error: no experiment named; give one with --config, or see what there is with "
              "--list, --doctor and --help");
    EXPECT_EQ(error_of({"--confg", "c.json"}),
              "ctpbench: error: unknown argument --confg; did you mean --config?");
    EXPECT_EQ(error_of({"--config", "c.json", "--xyzzy"}),
              "ctpbench: error: unknown argument --xyzzy; see ctpbench --help");
    EXPECT_EQ(error_of({"redner", "x"}), "ctpbench: error: unknown argument redner; did you mean render?");
    EXPECT_EQ(error_of({"render", "x", "--image", "i.png", "--rounds", "3"}),
              "ctpbench: error: --rounds means nothing to ctpbench render; see ctpbench render --help");
    for (const std::vector<const char*>& wrong :
         std::vector<std::vector<const char*>>{{"--config"},
                                               {"--config", "c", "--rounds", "0"},
                                               {"--config", "c", "--rounds", "x"},
                                               {"--config", "c", "--seed", "010"},
                                               {"--config", "c", "--seed", "18446744073709551616"},
                                               {"--config", "c", "--seed", "-1"},
                                               {"--config", "c", "--threads", "1025"},
                                               {"--config", "c", "--threads", "-1"},
                                               {"--config", "c", "--scenes", "fake"},
                                               {"--config", "c", "--set"},
                                               {"--config", "a", "--config", "b"},
                                               {"--config", "c", "--quiet=maybe"},
                                               {"render"},
                                               {"render", "x"},
                                               {"render", "x", "--image", "i", "--width", "0"},
                                               {"render", "x", "--image", "i", "--spheres", "-1"},
                                               {"render", "x", "--image", "i", "run"}}) {
        const std::string error = error_of(wrong);
        EXPECT_TRUE(error.starts_with("ctpbench: error: ")) << error << " " << wrong.back();
        EXPECT_NE(error.find("--help"), std::string::npos) << error;
    }
}

TEST(CommandLine, ResumeShardAndMerge) {
    const CommandLine line = parse({"--config", "c.json", "--out", "o", "--resume", "--shard", "2/3"});
    EXPECT_EQ(line.action, Action::run);
    EXPECT_TRUE(line.resume);
    EXPECT_EQ(line.shard, "2/3");
    const CommandLine merge = parse({"merge", "a", "b", "--out", "o"});
    EXPECT_EQ(merge.action, Action::merge);
    EXPECT_EQ(merge.folders, (std::vector<std::filesystem::path>{"a", "b"}));
    EXPECT_EQ(merge.out, "o");
    EXPECT_THROW(parse({"--config", "c.json", "--resume"}), Error);
    EXPECT_THROW(parse({"merge", "--out", "o"}), Error);
    EXPECT_THROW(parse({"merge", "a"}), Error);
}

}  // namespace
}  // namespace ctpbench
