#include "config/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <limits>
#include <map>

#include "base/error.h"
#include "base/suggest.h"

namespace ctpbench {
namespace {

constexpr const char* footer = R"(
Examples:
  ctpbench --config configs/smoke.json --out results/smoke
  ctpbench --config configs/table3.json --filter conference/1000/ --rounds 5
  ctpbench --config configs/table3.json --set /matrix/spheres=1000 --dry-run
  ctpbench --config configs/table3.json --backend cuda --set /batch_rays=0
  ctpbench --config configs/table3.json --out results/long --resume
  ctpbench merge results/sweep/shard-* --out results/sweep/all
  ctpbench render conference --spheres 1000 --samples 64 --image conference.png
  ctpbench compare results/before results/after --fail-ratio 0.9

Exit codes:
  0 ok   1 defect of the program   2 command line, config or scene file   3 scene missing
  4 a contender disagrees with the oracle   5 regression   6 unclear, with --strict
  7 backend cannot run here   8 results cannot be written   130 interrupted)";

const std::map<std::string, SceneChoice> scene_preferences = {
    {"auto", SceneChoice::auto_},
    {"real", SceneChoice::real},
    {"stand-in", SceneChoice::stand_in},
};

[[noreturn]] void refuse(const std::string& problem) {
    throw Error(ExitCode::usage, "ctpbench: error: " + problem);
}

// Digits alone: the library would wrap -1 around to a huge number and take 010 for eight.
CLI::Validator whole_number(std::uint64_t low, std::uint64_t high) {
    const auto problem = [low, high](const std::string& text) -> std::string {
        std::uint64_t value = 0;
        const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool octal = text.size() > 1 && text.front() == '0';
        const bool whole = failure == std::errc() && end == text.data() + text.size() && !octal;
        if (whole && value >= low && value <= high) return {};
        return "must be a whole number from " + std::to_string(low) + " to " + std::to_string(high) +
               ", found " + text;
    };
    return CLI::Validator(problem, "");
}

// One parse: the options, where they go, and what they ask for.
class Parser {
public:
    Parser() {
        app_.footer(footer);
        app_.set_version_flag(
            "--version", [] { return std::string(); }, "Print the version and stop");
        app_.require_subcommand(0, 1);
        add_shared_options();
        run_->fallthrough();
        render_->fallthrough();
        add_run_options();
        add_render_options();
        add_compare_options();
        add_merge_options();
    }

    CommandLine parse(int argc, const char* const* argv) {
        try {
            app_.parse(argc, argv);
        } catch (const CLI::CallForHelp&) {
            line_.action = CommandLine::Action::help;
            line_.help_text = render_->parsed()    ? render_->help("ctpbench")
                              : compare_->parsed() ? compare_->help("ctpbench")
                              : merge_->parsed()   ? merge_->help("ctpbench")
                                                   : app_.help();
            return line_;
        } catch (const CLI::CallForVersion&) {
            line_.action = CommandLine::Action::version;
            return line_;
        } catch (const CLI::ExtrasError&) {
            refuse_unknown(app_.remaining(true).front());
        } catch (const CLI::ParseError& error) {
            refuse(std::string(error.what()) + "; see ctpbench --help");
        }
        line_.scenes = scene_preferences.at(scenes_);
        line_.scene_dirs.assign(scene_dirs_.begin(), scene_dirs_.end());
        if (render_->parsed()) {
            finish_render();
        } else if (compare_->parsed()) {
            finish_compare();
        } else if (merge_->parsed()) {
            line_.action = CommandLine::Action::merge;
            line_.folders.assign(folders_.begin(), folders_.end());
        } else {
            finish_run();
        }
        return line_;
    }

private:
    void add_shared_options() {
        app_.add_option("--scene-dir", scene_dirs_, "Folder with scene files and meshes; may be repeated")
            ->type_name("DIR")
            ->allow_extra_args(false);
        app_.add_option("--scenes", scenes_,
                        "Take meshes or procedural stand-ins; auto: stand-ins where a mesh is missing")
            ->type_name("WHICH")
            ->check(CLI::IsMember({"auto", "real", "stand-in"}))
            ->capture_default_str();
        app_.add_option("--threads", line_.threads, "Threads; 0: all that the machine allows")
            ->type_name("N")
            ->check(whole_number(0, max_threads));
        app_.add_option("--seed", line_.seed, "Seed of every random number")
            ->type_name("N")
            ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()));
        app_.add_flag("--quiet", line_.quiet, "No progress, only results and errors");
    }

    void add_run_options() {
        const auto run_only = [this](CLI::Option* option) {
            run_only_.push_back(option);
            return option->group("Run");
        };
        run_only(app_.add_option("--config", line_.config, "Experiment to run"))->type_name("FILE");
        run_only(app_.add_option("--out", line_.out, "Folder for the results"))->type_name("DIR");
        run_only(app_.add_option("--rounds", rounds_, "Times that each contender is measured"))
            ->type_name("N")
            ->check(whole_number(1, max_rounds));
        const auto seconds = [&](const char* name, std::optional<double>& value, const char* what) {
            run_only(app_.add_option(name, value, what))
                ->type_name("SECONDS")
                ->check(CLI::Range(0.0, max_seconds));
        };
        seconds("--min-time", min_time_, "Rounds go on until those of a contest have taken this long");
        run_only(app_.add_option("--max-noise", max_noise_,
                                 "Rounds go on until each interval's half-width is this share of its ratio"))
            ->type_name("SHARE")
            ->check(CLI::Range(0.0, 1.0));
        seconds("--timeout", timeout_, "Rounds of a contest end after this time, whatever else is asked");
        run_only(app_.add_option("--filter", line_.filter,
                                 "Run only the cells whose name contains TEXT; --dry-run shows the names"))
            ->type_name("TEXT");
        run_only(app_.add_option("--set", sets_, "Change a value of the config; may be repeated"))
            ->type_name("/POINTER=VALUE")
            ->allow_extra_args(false);
        run_only(app_.add_option("--backend", line_.backends,
                                 "Run on these, whatever the config says: cpu, cuda, or auto: cpu, and cuda "
                                 "where there is a device"))
            ->type_name("NAME[,NAME]")
            ->delimiter(',')
            ->allow_extra_args(false)
            ->check(CLI::IsMember({"cpu", "cuda", "auto"}));
        run_only(app_.add_option("--device", line_.device, "CUDA device, by its number"))
            ->type_name("N")
            ->check(whole_number(0, 1023));
        run_only(app_.add_option("--isa", line_.isa,
                                 "Instruction set of traversal \"interleaved\"; else the best that there is"))
            ->type_name("NAME")
            ->check(CLI::IsMember({"avx512", "avx2", "scalar"}));
        run_only(app_.add_flag("--resume", line_.resume,
                               "Go on with the run in --out if there is one: keep the workloads that it has "
                               "finished, measure the others"));
        run_only(app_.add_option("--shard", line_.shard,
                                 "Run share I of N, from 1/N to N/N: every Nth workload with all its "
                                 "contenders; see ctpbench merge"))
            ->type_name("I/N");
        run_only(app_.add_flag("--dry-run", dry_run_,
                               "Show the cells, measure a small part of each workload, say how long the run "
                               "would take, and stop"));
        run_only(app_.add_flag("--list", list_, "Show the names that a config may use and stop"));
        run_only(app_.add_flag("--schema", schema_, "Print the JSON Schema of configs and stop"));
        run_only(app_.add_flag("--doctor", doctor_,
                               "Say what this build and machine can do and what is missing, and stop"));
    }

    void add_render_options() {
        render_->add_option("name", line_.scene, "Scene to render")->type_name("")->required();
        render_
            ->add_option("--image", line_.image,
                         "Image to write: linear light in an EXR file, exposed and in sRGB in others")
            ->type_name("FILE")
            ->required();
        const auto number = [this](const char* name, std::uint32_t& value, const char* help,
                                   std::uint32_t low, std::uint32_t high) {
            render_->add_option(name, value, help)
                ->type_name("N")
                ->check(whole_number(low, high))
                ->capture_default_str();
        };
        number("--width", line_.width, "Pixels", 1, max_image_side);
        number("--height", line_.height, "Pixels", 1, max_image_side);
        number("--samples", line_.samples, "Paths per pixel", 1, max_rounds);
        number("--bounces", line_.bounces, "Bounces of a path", 1, max_bounces);
        number("--spheres", line_.spheres, "Spheres to scatter", 0, max_spheres);
        render_->add_option("--exposure", line_.exposure, "Factor on the image, in place of the scene's")
            ->type_name("X")
            ->check(CLI::PositiveNumber);
        render_->footer(
            "Takes --scene-dir, --scenes, --threads, --seed and --quiet too; see ctpbench --help.");
    }

    void add_compare_options() {
        compare_->add_option("BASE", line_.base, "Folder of results, or of several runs' folders")
            ->type_name("")
            ->required();
        compare_->add_option("NEW", line_.fresh, "Likewise, of what is set beside BASE")
            ->type_name("")
            ->required();
        compare_
            ->add_option("--fail-ratio", line_.fail_ratio,
                         "A regression if the upper end of the interval of NEW / BASE is below this")
            ->type_name("RATIO")
            ->check(CLI::Range(0.01, 1.0))
            ->capture_default_str();
        compare_->add_flag("--strict", line_.strict,
                           "Fail too if a verdict is UNCLEAR, or something not compared");
        compare_->footer("Exit codes: 0 no regression   5 regression   6 unclear, with --strict");
    }

    void finish_compare() {
        line_.action = CommandLine::Action::compare;
        for (const CLI::Option* option : app_.get_options())
            if (option->count() > 0)
                refuse(option->get_name() +
                       " means nothing to ctpbench compare; see ctpbench compare --help");
    }

    void add_merge_options() {
        merge_->add_option("folders", folders_, "Folders of results, one of each shard")
            ->type_name("DIR")
            ->required();
        merge_->add_option("--out", line_.out, "Folder for the results")->type_name("DIR")->required();
        merge_->footer(
            "Refuses folders of different configs, scenes or programs, and shards that are not complete.");
    }

    void finish_render() {
        line_.action = CommandLine::Action::render;
        for (const CLI::Option* option : run_only_) {
            if (option->count() > 0) {
                refuse(option->get_name() + " means nothing to ctpbench render; see ctpbench render --help");
            }
        }
    }

    void finish_run() {
        if (line_.resume && line_.out.empty())
            refuse("--resume needs the folder of the run that it is to go on with; name it with --out");
        if (list_) {
            line_.action = CommandLine::Action::list;
        } else if (schema_) {
            line_.action = CommandLine::Action::schema;
        } else if (doctor_) {
            line_.action = CommandLine::Action::doctor;
        } else if (line_.config.empty()) {
            refuse(
                "no experiment named; give one with --config, or see what there is with --list, --doctor and "
                "--help");
        } else if (dry_run_) {
            line_.action = CommandLine::Action::dry_run;
        }
        for (const std::string& assignment : sets_)
            line_.edits.push_back({assignment, "--set " + assignment});
        add_edit("threads", line_.threads);
        add_edit("rounds", rounds_);
        add_edit("seed", line_.seed);
        add_edit("min_time", min_time_, "--min-time");
        add_edit("max_noise", max_noise_, "--max-noise");
        add_edit("timeout", timeout_, "--timeout");
    }

    template <class T>
    void add_edit(const std::string& key, const std::optional<T>& value, const std::string& option = {}) {
        if (!value) return;
        char text[32];
        const std::string written(text, std::to_chars(text, text + sizeof text, *value).ptr);
        line_.edits.push_back(
            {"/" + key + "=" + written, (option.empty() ? "--" + key : option) + " " + written});
    }

    [[noreturn]] void refuse_unknown(const std::string& argument) const {
        std::vector<std::string> known = {"run", "render", "compare", "merge"};
        for (const CLI::App* app : std::initializer_list<const CLI::App*>{&app_, render_, compare_}) {
            for (const CLI::Option* option : app->get_options()) known.push_back(option->get_name());
        }
        if (std::find(known.begin(), known.end(), argument) != known.end()) {
            refuse(argument + " is not expected here; see ctpbench --help");
        }
        const auto nearest = nearest_name(argument.substr(0, argument.find('=')), known);
        refuse("unknown argument " + argument +
               (nearest ? "; did you mean " + *nearest + "?" : "; see ctpbench --help"));
    }

    CommandLine line_;
    std::vector<std::string> scene_dirs_;
    std::vector<std::string> sets_;
    std::vector<std::string> folders_;
    std::string scenes_ = "auto";
    std::optional<std::uint32_t> rounds_;
    std::optional<double> min_time_, max_noise_, timeout_;
    bool dry_run_ = false;
    bool list_ = false, schema_ = false, doctor_ = false;
    std::vector<const CLI::Option*> run_only_;

    CLI::App app_{"Measures how a ray tracer's inner loops should branch on type.", "ctpbench"};
    CLI::App* run_ = app_.add_subcommand("run", "Run an experiment; implied if no subcommand is named");
    CLI::App* render_ = app_.add_subcommand("render", "Render one scene into an image");
    CLI::App* compare_ = app_.add_subcommand("compare", "Set two folders of results beside each other");
    CLI::App* merge_ = app_.add_subcommand("merge", "Make one run's results of those of its shards");
};

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) { return Parser().parse(argc, argv); }

}  // namespace ctpbench
