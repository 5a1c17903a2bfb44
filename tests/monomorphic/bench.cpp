// Holds strategies against the hand-written kernels, in time, on a scene of triangles in plain colours:
//   ctpbench_monomorphic [SCENE] [--rounds N] ...
// Exit code 1 if hits or images differ, 2 if something is wrong with the command line or the scene.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "measure/statistics.h"
#include "monomorphic/matte_scene.h"
#include "monomorphic/races.h"
#include "scene/load_scene.h"

namespace ctpbench::monomorphic {
namespace {

struct Options {
    std::string scene = "conference_like";
    std::vector<std::string> scene_dirs;
    std::vector<std::string> intersect{"ctp"}, shade{"ctp"};
    std::uint32_t rounds = 21;
    int threads = 0;
    FrameSettings frame{1024, 1024, 10, 1};
    std::uint32_t batch_rays = 131072;
};

void declare(CLI::App& app, Options& o) {
    app.add_option("SCENE", o.scene, "Scene file's name or path")->capture_default_str();
    app.add_option("--scene-dir", o.scene_dirs, "Folder with scene files and meshes; may be repeated")
        ->type_name("DIR")
        ->allow_extra_args(false);
    app.add_option("--intersect", o.intersect, "Intersect strategies, separated by commas")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--shade", o.shade, "Shade strategies, separated by commas")
        ->delimiter(',')
        ->capture_default_str();
    app.add_option("--rounds", o.rounds, "Times that each contender is measured")
        ->check(CLI::Range(1u, 10000u))
        ->capture_default_str();
    app.add_option("--threads", o.threads, "Threads; 0: all that the machine allows")
        ->check(CLI::Range(0, 1024));
    app.add_option("--width", o.frame.width, "Pixels")->check(CLI::Range(1u, 16384u))->capture_default_str();
    app.add_option("--height", o.frame.height, "Pixels")
        ->check(CLI::Range(1u, 16384u))
        ->capture_default_str();
    app.add_option("--bounces", o.frame.bounces, "Intersections of a path after the camera ray's")
        ->check(CLI::Range(0u, 100u))
        ->capture_default_str();
    app.add_option("--batch-rays", o.batch_rays, "Rays timed of each bounce; 0: all")->capture_default_str();
}

Scene load(const Options& o) {
    SceneRequest request;
    request.name = o.scene;
    request.scene_dirs.assign(o.scene_dirs.begin(), o.scene_dirs.end());
    request.spheres = 0;
    Notices notices;
    Scene scene = load_scene(request, notices);
    for (const std::string& n : notices) std::fprintf(stderr, "%s\n", n.c_str());
    make_matte(scene);
    return scene;
}

void print(const char* stage, const Race& race) {
    std::printf("%-10s %-16s %10s %28s %31s\n", stage, "", "Mrays/s", "ms a round [95 %]",
                "time / by_hand [95 %]");
    for (const Racer& racer : race.racers) {
        const Estimate s = estimate_median(racer.seconds);
        std::printf("%-10s %-16s %10.3f %10.2f [%7.2f, %7.2f]", "", racer.name.c_str(),
                    static_cast<double>(race.paths) / s.median * 1e-6, s.median * 1e3, s.lo * 1e3,
                    s.hi * 1e3);
        const Estimate ratio = estimate_paired_ratio(racer.seconds, race.racers[0].seconds);
        if (&racer == &race.racers[0])
            std::printf("%15d\n", 1);
        else
            std::printf("%15.4f [%6.4f, %6.4f]\n", ratio.median, ratio.lo, ratio.hi);
    }
}

std::vector<std::string> with_reference(std::vector<std::string> names) {
    names.insert(names.begin(), kByHand);
    return names;
}

void run(const Options& o) {
    const Scene scene = load(o);
    Stage stage(scene, o.threads, trees_of(o.intersect));
    std::vector<Batch> batches = record_bounces(stage, o.frame, o.batch_rays);
    std::printf(
        "%s (%s): %zu triangles, %zu materials made matte; %ux%u, %zu bounces, %d threads, %u rounds\n",
        scene.name.c_str(), scene.source == SceneSource::mesh ? "mesh" : "stand-in",
        scene.mesh.triangles.size(), scene.materials.size(), o.frame.width, o.frame.height, batches.size(),
        stage.backend.threads(), o.rounds);
    print("intersect", race_intersect(stage, with_reference(o.intersect), batches, o.rounds));
    std::fflush(stdout);
    print("shade", race_shade(stage, with_reference(o.shade), o.frame, o.rounds));
}

}  // namespace
}  // namespace ctpbench::monomorphic

int main(int argc, char** argv) {
    using namespace ctpbench::monomorphic;
    CLI::App app("Holds strategies against kernels written by hand for matte triangles alone");
    Options options;
    declare(app, options);
    CLI11_PARSE(app, argc, argv);
    try {
        run(options);
    } catch (const Differ& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    return 0;
}
