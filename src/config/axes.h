// The axes that a config's matrix spans. A further axis is a member, a line in for_each_axis() and its
// place in Cell (cells.h); reading, writing, excluding and including follow from these.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ctpbench {

// Values along each axis, in the order written. In `exclude` an empty axis stands for any value.
struct Axes {
    std::vector<std::string> scene;
    std::vector<std::uint32_t> spheres;
    std::vector<double> sphere_radius;  // as a share of the spheres' mean spacing
    std::vector<std::string> builder;
    std::vector<std::string> backend;
    std::vector<std::string> strategy;
    std::vector<bool> restart_carries_t;
    std::vector<std::string> traversal;
    std::vector<std::string> methods;
    std::vector<std::string> types;                                 // that kernels are compiled for
    std::vector<std::string> shade;                                 // no_shade: intersect alone is measured
    std::vector<std::string> launch;                                // of frames' kernels on a GPU
    std::vector<std::string> triangle_test, sphere_test, box_test;  // of_bundle: what `methods` names
    std::vector<std::string> offset;                                // of rays that leave a surface; likewise
    std::vector<std::uint32_t> bounce_limit;                        // of frames; 0: the config's `bounces`
    std::vector<bool> roulette;                                     // of frames
    std::vector<std::uint32_t> threads;  // of the CPU, for recorded rays; 0: the run's

    bool operator==(const Axes&) const = default;
};

// The value of the shade axis with which nothing is shaded: recorded rays are intersected. With any other,
// whole frames are rendered.
inline constexpr const char* no_shade = "none";

// A test or offset that is not exchanged: the bundle's own.
inline constexpr const char* of_bundle = "bundle";

// Kernels are compiled for the types that the scene has.
inline constexpr const char* types_of_scene = "scene";

// What an axis has that the config does not mention.
inline Axes default_axes() {
    return {{"smoke"},   {1000},      {0.03},         {"quality"},      {"cpu"},    {"ctp"},
            {true},      {"single"},  {"watertight"}, {types_of_scene}, {no_shade}, {"isolated"},
            {of_bundle}, {of_bundle}, {of_bundle},    {of_bundle},      {0},        {false},
            {0}};
}

// Whether the axis belongs to what is traced, not to who traces it.
inline bool is_workload_axis(std::string_view name) {
    return name == "scene" || name == "spheres" || name == "sphere_radius" || name == "builder";
}

// Calls f(name, values) for each axis.
template <class AxesOrConst, class F>
void for_each_axis(AxesOrConst& axes, F&& f) {
    f("scene", axes.scene);
    f("spheres", axes.spheres);
    f("sphere_radius", axes.sphere_radius);
    f("builder", axes.builder);
    f("backend", axes.backend);
    f("strategy", axes.strategy);
    f("restart_carries_t", axes.restart_carries_t);
    f("traversal", axes.traversal);
    f("methods", axes.methods);
    f("types", axes.types);
    f("shade", axes.shade);
    f("launch", axes.launch);
    f("triangle_test", axes.triangle_test);
    f("sphere_test", axes.sphere_test);
    f("box_test", axes.box_test);
    f("offset", axes.offset);
    f("bounce_limit", axes.bounce_limit);
    f("roulette", axes.roulette);
    f("threads", axes.threads);
}

}  // namespace ctpbench
