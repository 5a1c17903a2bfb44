// What Zellmann & Lang 2017 printed, to be set beside our own figures.
#pragma once

#include <cstdint>
#include <string_view>

namespace ctpbench::paper {

// Table 3: intersect, Mrays/s; dual Xeon E5-2637 v2, 16 threads, and GeForce GTX 1080 Ti; 0: not applicable.
struct Table3Row {
    std::string_view backend;
    std::string_view scene;
    std::uint32_t spheres;
    double ctp, oop, restart;
};
inline constexpr Table3Row table3[] = {
    {"cpu", "san_miguel", 1000, 4.56, 3.91, 4.33},   {"cpu", "san_miguel", 10000, 4.25, 3.63, 4.05},
    {"cpu", "san_miguel", 100000, 3.97, 3.32, 3.58}, {"cpu", "conference", 1000, 12.6, 11.8, 10.9},
    {"cpu", "conference", 10000, 10.2, 9.46, 8.72},  {"cpu", "conference", 100000, 7.39, 6.67, 6.51},
    {"cuda", "san_miguel", 1000, 9.48, 0, 27.3},     {"cuda", "san_miguel", 10000, 8.78, 0, 25.8},
    {"cuda", "san_miguel", 100000, 7.59, 0, 21.3},   {"cuda", "conference", 1000, 17.8, 0, 81.5},
    {"cuda", "conference", 10000, 13.1, 0, 66.5},    {"cuda", "conference", 100000, 9.52, 0, 36.8},
};

// Table 1: kernels of a bounce, Mrays/s, 1024x1024 pixels, on the same; 0: not applicable.
struct Table1Row {
    std::string_view backend, scene, kernel;
    double ctp, oop, sort;
};
inline constexpr Table1Row table1[] = {
    {"cpu", "conference", "intersect", 12.9, 12.8, 12.5},
    {"cpu", "conference", "sort", 0, 0, 45.4},
    {"cpu", "conference", "shade", 31.6, 30.4, 22.6},
    {"cpu", "conference", "compact", 389, 395, 453},
    {"cpu", "sponza", "intersect", 6.55, 6.53, 6.32},
    {"cpu", "sponza", "sort", 0, 0, 41.6},
    {"cpu", "sponza", "shade", 32.3, 29.5, 22.9},
    {"cpu", "sponza", "compact", 542, 581, 685},
    {"cuda", "conference", "intersect", 56.2, 0, 51.8},
    {"cuda", "conference", "sort", 0, 0, 359},
    {"cuda", "conference", "shade", 362, 0, 342},
    {"cuda", "conference", "compact", 586, 0, 234},
    {"cuda", "sponza", "intersect", 28.6, 0, 26.5},
    {"cuda", "sponza", "sort", 0, 0, 372},
    {"cuda", "sponza", "shade", 307, 0, 272},
    {"cuda", "sponza", "compact", 737, 0, 183},
};

// Table 2: nodes, in thousands, of the trees over triangles and spheres; 0 spheres: triangles alone.
struct Table2Row {
    std::string_view scene;
    std::uint32_t spheres;
    double kilo_nodes;
};
inline constexpr Table2Row table2[] = {
    {"san_miguel", 0, 5971},      {"san_miguel", 1000, 5976},  {"san_miguel", 10000, 5986},
    {"san_miguel", 100000, 6047}, {"conference", 0, 252},      {"conference", 1000, 253},
    {"conference", 10000, 260},   {"conference", 100000, 328},
};

// Triangles of the paper's editions of the meshes.
inline constexpr double san_miguel_kilo_triangles = 7842;
inline constexpr double conference_kilo_triangles = 331;

}  // namespace ctpbench::paper
