// The command line as a plain struct. What the values mean is for others to know; here they are only read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/config.h"
#include "config/scene_choice.h"

namespace ctpbench {

struct CommandLine {
    enum class Action {
        run,
        dry_run,  // show the cells and stop
        list,     // show the names that a config may use and stop
        schema,   // print the JSON Schema of configs and stop
        doctor,   // say what this build and machine can do and stop
        render,   // render one scene into an image
        compare,  // set two folders of results beside each other
        merge,    // make one run's results of those of its shards
        version,
        help,  // print help_text
    };
    Action action = Action::run;
    std::string help_text;

    // For every action that needs scenes.
    std::vector<std::filesystem::path> scene_dirs;  // searched in this order, before the program's own
    SceneChoice scenes = SceneChoice::auto_;
    std::optional<std::uint32_t> threads;
    std::optional<std::uint64_t> seed;
    bool quiet = false;

    // run and dry_run
    std::filesystem::path config;
    std::filesystem::path out;  // empty: not given
    std::string filter;
    std::vector<std::string> backends;  // "cpu", "cuda" or "auto"; empty: what the config says
    int device = 0;                     // number of the CUDA device
    std::string isa;                    // of kernels over packs; empty: the best that this machine has
    std::vector<ConfigEdit> edits;      // --set in the order given, then those with options of their own

    bool resume = false;
    std::string shard;  // `2/8`; empty: all

    // merge, into `out`
    std::vector<std::filesystem::path> folders;

    // render
    std::string scene;
    std::filesystem::path image;
    std::uint32_t width = 1280;
    std::uint32_t height = 720;
    std::uint32_t spheres = 0;
    std::uint32_t samples = 64;  // per pixel
    std::uint32_t bounces = 10;
    std::optional<float> exposure;  // none: the scene's

    // compare
    std::filesystem::path base, fresh;
    double fail_ratio = 0.9;
    bool strict = false;
};

// Throws Error(usage) with the problem and a hint.
CommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace ctpbench
