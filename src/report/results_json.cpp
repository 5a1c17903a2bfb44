#include "report/results_json.h"

#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>

namespace ctpbench {
namespace {

using nlohmann::json;

template <class S, class T>
concept Like = std::is_same_v<std::remove_const_t<S>, T>;

// each_member(struct, f) calls f(name, member) for every member; writing and reading both follow from it. The
// structured bindings make a struct that has got a further member fail to compile here.

void each_member(Like<Workload> auto& s, auto&& f) {
    auto& [scene, spheres, sphere_radius, builder] = s;
    f("scene", scene), f("spheres", spheres), f("sphere_radius", sphere_radius), f("builder", builder);
}

void each_member(Like<Contender> auto& s, auto&& f) {
    auto& [backend, strategy, restart_carries_t, traversal, methods, shade, launch, triangle_test,
           sphere_test, box_test, offset, bounce_limit, roulette, types, threads] = s;
    f("backend", backend), f("strategy", strategy), f("restart_carries_t", restart_carries_t);
    f("traversal", traversal), f("methods", methods), f("shade", shade), f("launch", launch);
    f("triangle_test", triangle_test), f("sphere_test", sphere_test), f("box_test", box_test);
    f("offset", offset), f("bounce_limit", bounce_limit), f("roulette", roulette), f("types", types);
    f("threads", threads);
}

void each_member(Like<Verdict> auto& s, auto&& f) {
    auto& [rays, match, tie, reference_wrong, boundary, t_mismatch, wrong_primitive, missed, false_hit,
           not_finite, leak] = s;
    f("rays", rays), f("match", match), f("tie", tie), f("reference_wrong", reference_wrong);
    f("boundary", boundary), f("t_mismatch", t_mismatch), f("wrong_primitive", wrong_primitive);
    f("missed", missed), f("false_hit", false_hit), f("not_finite", not_finite), f("leak", leak);
}

void each_member(Like<Accuracy> auto& s, auto&& f) {
    auto& [verdict, p99_scaled_error] = s;
    f("verdict", verdict), f("p99_scaled_error", p99_scaled_error);
}

void each_member(Like<KernelSeries> auto& s, auto&& f) {
    auto& [kernel, rays, mrays, seconds] = s;
    f("kernel", kernel), f("rays", rays), f("mrays", mrays), f("seconds", seconds);
}

void each_member(Like<BounceSeries> auto& s, auto&& f) {
    auto& [bounce, mrays, against_reference] = s;
    f("bounce", bounce), f("mrays", mrays), f("against_reference", against_reference);
}

void each_member(Like<BoundedValue> auto& s, auto&& f) {
    auto& [value, lo, hi] = s;
    f("value", value), f("lo", lo), f("hi", hi);
}

void each_member(Like<Convergence> auto& s, auto&& f) {
    auto& [seconds, relmse, bias] = s;
    f("seconds", seconds), f("relmse", relmse), f("bias", bias);
}

void each_member(Like<CellResult> auto& s, auto&& f) {
    auto& [workload, contender, scene_source, triangles, checked, valid, reason, verdict, accuracy, kernels,
           bounces, layout_bytes, image_hash, samples, shaded, dropped, clamped, convergence, stopped_by] = s;
    f("workload", workload), f("contender", contender), f("scene_source", scene_source);
    f("triangles", triangles), f("checked", checked), f("valid", valid), f("reason", reason);
    f("verdict", verdict), f("accuracy", accuracy), f("kernels", kernels), f("bounces", bounces);
    f("layout_bytes", layout_bytes), f("image_hash", image_hash), f("samples", samples), f("shaded", shaded);
    f("dropped", dropped), f("clamped", clamped), f("convergence", convergence), f("stopped_by", stopped_by);
}

void each_member(Like<TreeResult> auto& s, auto&& f) {
    auto& [workload, kind, primitives, nodes, references, depth, sah, build_seconds, bytes, hash] = s;
    f("workload", workload), f("kind", kind), f("primitives", primitives), f("nodes", nodes);
    f("references", references), f("depth", depth), f("sah", sah), f("build_seconds", build_seconds);
    f("bytes", bytes), f("hash", hash);
}

void each_member(Like<SceneNeeds> auto& s, auto&& f) {
    auto& [primitives, materials, textured] = s;
    f("primitives", primitives), f("materials", materials), f("textured", textured);
}

void each_member(Like<SceneSavings> auto& s, auto&& f) {
    auto& [unused_vertices, unused_texcoords, unused_materials, merged_materials] = s;
    f("unused_vertices", unused_vertices), f("unused_texcoords", unused_texcoords);
    f("unused_materials", unused_materials), f("merged_materials", merged_materials);
}

void each_member(Like<SceneColumn> auto& s, auto&& f) {
    auto& [name, bytes] = s;
    f("name", name), f("bytes", bytes);
}

void each_member(Like<SceneResult> auto& s, auto&& f) {
    auto& [name, spheres, source, triangles, dropped_triangles, hash, base_hash, needs, savings, columns,
           sphere_hit_share] = s;
    f("name", name), f("spheres", spheres), f("source", source), f("triangles", triangles);
    f("dropped_triangles", dropped_triangles), f("hash", hash), f("base_hash", base_hash), f("needs", needs);
    f("savings", savings), f("columns", columns), f("sphere_hit_share", sphere_hit_share);
}

void each_member(Like<FlightProfile::Phase> auto& s, auto&& f) {
    auto& [cycles, items, loops] = s;
    f("cycles", cycles), f("items", items), f("loops", loops);
}

void each_member(Like<FlightProfile> auto& s, auto&& f) {
    auto& [phases] = s;
    for (std::uint32_t i = 0; i < kFlightPhases; ++i) f(kFlightPhaseNames[i], phases[i]);
}

void each_member(Like<ProfileResult> auto& s, auto&& f) {
    auto& [workload, bounce, rays, isa, profile] = s;
    f("workload", workload), f("bounce", bounce), f("rays", rays), f("isa", isa), f("profile", profile);
}

void each_member(Like<StabilityRow> auto& s, auto&& f) {
    auto& [kind, method, backend, is_default, workload, accuracy] = s;
    f("kind", kind), f("method", method), f("backend", backend), f("is_default", is_default);
    f("workload", workload), f("accuracy", accuracy);
}

void each_member(Like<Results> auto& s, auto&& f) {
    auto& [cells, profiles, trees, scenes, stability, notices] = s;
    f("cells", cells), f("profiles", profiles), f("trees", trees), f("scenes", scenes);
    f("stability", stability), f("notices", notices);
}

// JSON has no number that is none: NaN becomes null.
template <class T>
json written(const T& value) {
    if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
        return value;
    } else if constexpr (requires { value.has_value(); }) {
        return value ? written(*value) : json();
    } else if constexpr (requires { value.begin(); }) {
        json list = json::array();
        for (const auto& element : value) list.push_back(written(element));
        return list;
    } else {
        json object = json::object();
        each_member(value, [&](const char* name, const auto& member) { object[name] = written(member); });
        return object;
    }
}

template <class T>
void read(const json& from, T& value) {
    if constexpr (std::is_floating_point_v<T>) {
        value = from.is_null() ? std::numeric_limits<T>::quiet_NaN() : from.get<T>();
    } else if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
        from.get_to(value);
    } else if constexpr (requires { value.has_value(); }) {
        value.reset();
        if (!from.is_null()) read(from, value.emplace());
    } else if constexpr (requires { value.begin(); }) {
        value.clear();
        for (const json& element : from) read(element, value.emplace_back());
    } else {
        each_member(value, [&](const char* name, auto& member) { read(from.at(name), member); });
    }
}

}  // namespace

json results_to_json(const Results& results) { return written(results); }

Results results_from_json(const json& json) {
    Results results;
    read(json, results);
    return results;
}

}  // namespace ctpbench
