// The command line: reads it, does what it says, and turns errors into exit codes.
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>

#include "backends/cuda.h"
#include "base/error.h"
#include "base/interrupt.h"
#include "build_info.h"
#include "compare.h"
#include "config/command_line.h"
#include "config/schema.h"
#include "doctor.h"
#include "estimate.h"
#include "experiment.h"
#include "memory_needs.h"
#include "merge.h"
#include "render.h"
#include "scene/find_scene.h"
#include "wavefront/interleaved/isa.h"

namespace ctpbench {
namespace {

// As a shell reads it back: what is not plain goes between single quotes.
std::string quoted(const std::string& argument) {
    const auto is_plain = [](unsigned char c) {
        return std::isalnum(c) ||
               std::string_view("_%+=:,./-").find(static_cast<char>(c)) != std::string::npos;
    };
    if (!argument.empty() && std::all_of(argument.begin(), argument.end(), is_plain)) return argument;
    std::string out = "'";
    for (const char c : argument) out += c == '\'' ? "'\\''" : std::string(1, c);
    return out + "'";
}

std::string joined(int argc, char** argv) {
    std::string command;
    for (int i = 0; i < argc; ++i) command += (i > 0 ? " " : "") + quoted(argv[i]);
    return command;
}

void print_names(const char* kind, const std::vector<std::string>& names) {
    std::printf("%s:", kind);
    for (const std::string& name : names) std::printf(" %s", name.c_str());
    std::printf("\n");
}

void list(const CommandLine& line) {
    const KnownNames names = known_names();
    print_names("scenes", scene_names(scene_search_path(line.scene_dirs)));
    print_names("strategies", names.strategies);
    std::vector<std::string> yardsticks;
    for (const KnownNames::Yardstick& y : names.yardsticks) yardsticks.push_back(y.name);
    print_names("yardsticks", yardsticks);
    print_names("shade strategies", names.shades);
    print_names("traversals", names.traversals);
    print_names("methods", names.methods);
    print_names("types", names.types);
    print_names("triangle tests", names.triangle_tests);
    print_names("sphere tests", names.sphere_tests);
    print_names("box tests", names.box_tests);
    print_names("offsets", names.offsets);
    print_names("builders", names.builders);
    print_names("backends", names.backends);
    print_names("instruction sets", usable_isas());
    print_names("launches", names.launches);
    print_names("studies", names.studies);
    std::vector<std::string> stress;
    for (const KnownNames::Stress& s : names.stress) stress.push_back(s.name);
    print_names("stress workloads", stress);
    const std::string obstacle = cuda_obstacle(line.device);
    std::printf("cuda: %s\n", obstacle.empty() ? "usable" : obstacle.c_str());
}

// "auto" resolved; a notice says why CUDA was left out.
std::vector<std::string> backends_of(const CommandLine& line, std::string& notice) {
    std::vector<std::string> backends;
    const auto add = [&](const std::string& name) {
        if (std::find(backends.begin(), backends.end(), name) == backends.end()) backends.push_back(name);
    };
    for (const std::string& name : line.backends) {
        if (name != "auto") {
            add(name);
            continue;
        }
        add("cpu");
        const std::string obstacle = cuda_obstacle(line.device);
        if (obstacle.empty())
            add("cuda");
        else
            notice = "cpu only: " + obstacle;
    }
    return backends;
}

// The one asked for, or the best.
std::string isa_of(const CommandLine& line) {
    const std::vector<std::string> usable = usable_isas();
    if (line.isa.empty()) return usable.front();
    if (std::find(usable.begin(), usable.end(), line.isa) != usable.end()) return line.isa;
    std::string all;
    for (const std::string& name : usable) all += " " + name;
    throw Error(ExitCode::no_backend,
                "ctpbench: error: --isa " + line.isa + ": this machine cannot run it; it can run" + all);
}

ExitCode run(const CommandLine& line, const std::string& command) {
    RunOptions options;
    KnownNames names = known_names();
    names.only_backends = backends_of(line, options.notice);
    const Config config = load_config(line.config, line.edits, names);
    const std::vector<Cell> cells = filter(expand(config, names), line.filter);
    if (config.study != Study::stability) {  // whose workloads are made, not loaded
        std::set<std::string> scenes;
        for (const Cell& cell : cells) scenes.insert(cell.workload.scene);
        require_scenes(scenes, line.scenes, line.scene_dirs);
    }
    require_memory_for(cells, config);
    if (!line.shard.empty()) options.shard = parse_shard(line.shard);
    options.out = line.out;
    options.resume = line.resume;
    options.device = line.device;
    options.isa = isa_of(line);
    options.scene_dirs = line.scene_dirs;
    options.scenes = line.scenes;
    options.quiet = line.quiet;
    options.command = command;
    if (line.action == CommandLine::Action::dry_run) return estimate(config, cells, options);
    return run_experiment(config, cells, options);
}

ExitCode perform(int argc, char** argv) {
    const CommandLine line = parse_command_line(argc, argv);
    switch (line.action) {
        case CommandLine::Action::help:
            std::printf("%s", line.help_text.c_str());
            break;
        case CommandLine::Action::version:
            std::printf("ctpbench %s (%.12s)\n", CTPBENCH_VERSION, CTPBENCH_GIT_COMMIT);
            break;
        case CommandLine::Action::list:
            list(line);
            break;
        case CommandLine::Action::schema:
            std::printf("%s\n", config_schema(known_names()).dump(4).c_str());
            break;
        case CommandLine::Action::doctor:
            return examine(line);
        case CommandLine::Action::render:
            require_memory_for_picture(line.width, line.height, line.spheres);
            return render(line);
        case CommandLine::Action::compare:
            return compare(line);
        case CommandLine::Action::merge:
            return merge_runs(line.folders, line.out, joined(argc, argv));
        case CommandLine::Action::run:
        case CommandLine::Action::dry_run:
            return run(line, joined(argc, argv));
    }
    return ExitCode::ok;
}

}  // namespace
}  // namespace ctpbench

int main(int argc, char** argv) {
    using namespace ctpbench;
    watch_for_interrupt();
    try {
        return static_cast<int>(perform(argc, argv));
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return static_cast<int>(error.code());
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr,
                     "ctpbench: error: out of memory; use fewer spheres, a smaller scene or fewer pixels\n");
        return static_cast<int>(ExitCode::internal);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "ctpbench: internal error: %s\n", error.what());
        return static_cast<int>(ExitCode::internal);
    }
}
