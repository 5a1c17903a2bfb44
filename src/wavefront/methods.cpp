#include "wavefront/methods.h"

#include "config/axes.h"

#include <algorithm>

#include "base/suggest.h"
#include "base/type_names.h"
#include "kernels/dispatch/ctp.h"
#include "kernels/methods/exchanges.h"
#include "wavefront/intersector.h"

namespace ctpbench {
namespace {

// A choice with every part named.
struct Parts {
    std::string triangle, sphere, box, offset;

    bool excludes() const { return offset == ExcludeId::name; }
    // Of the tests alone.
    std::string key() const {
        for (const MethodsInfo& m : method_bundles())
            if (triangle == m.triangle_test && sphere == m.sphere_test && box == m.box_test) return m.name;
        return tests_key(triangle, sphere, box);
    }
};

// The bundle must be known.
Parts parts_of(const std::string& bundle, const std::string& triangle, const std::string& sphere,
               const std::string& box, const std::string& offset) {
    const auto part = [](const std::string& chosen, const std::string& own) {
        return chosen == of_bundle ? own : chosen;
    };
    for (const MethodsInfo& m : method_bundles())
        if (m.name == bundle)
            return {part(triangle, m.triangle_test), part(sphere, m.sphere_test), part(box, m.box_test),
                    part(offset, m.offset)};
    trap();
}

// Calls f(TypeTag<Methods>{}) for all that strategy `ctp` alone is offered with.
template <class F>
void for_each_exchange(F&& f) {
    for_each_type(TriangleTests{},
                  [&](auto tag) { for_each_type(TestsWithTriangle<typename decltype(tag)::type>{}, f); });
    for_each_type(TestsWithSpheres{}, f);
    for_each_type(TypeList<ExcludingTests>{}, f);
}

bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string unknown_part(const std::string& what, const std::string& name, std::vector<std::string> known) {
    known.push_back(of_bundle);
    return has(known, name) ? "" : unknown_name(what, name, known);
}

}  // namespace

std::vector<MethodsInfo> method_bundles() {
    std::vector<MethodsInfo> all;
    for_each_type(MethodBundles{}, [&](auto tag) {
        using M = typename decltype(tag)::type;
        all.push_back({M::name, M::Triangle::name, M::Sphere::name, M::Box::name, M::Offset::name, M::exact});
    });
    return all;
}

std::vector<std::string> triangle_tests() { return names_of<TriangleTests>(); }
std::vector<std::string> sphere_tests() { return names_of<SphereTests>(); }
std::vector<std::string> box_tests() { return names_of<BoxTests>(); }
std::vector<std::string> offsets() { return names_of<Offsets>(); }

std::string methods_obstacle(const std::string& strategy, const std::string& bundle,
                             const std::string& triangle_test, const std::string& sphere_test,
                             const std::string& box_test, const std::string& offset) {
    std::vector<std::string> strategies;
    for (const StrategyInfo& s : intersect_strategies()) strategies.push_back(s.name);
    const std::vector<std::string> bundles = names_of<MethodBundles>();
    if (!has(strategies, strategy)) return unknown_name("strategy", strategy, strategies);
    if (!has(bundles, bundle)) return unknown_name("methods", bundle, bundles);
    for (const std::string& why :
         {unknown_part("triangle test", triangle_test, triangle_tests()),
          unknown_part("sphere test", sphere_test, sphere_tests()),
          unknown_part("box test", box_test, box_tests()), unknown_part("offset", offset, offsets())})
        if (!why.empty()) return why;

    const Parts parts = parts_of(bundle, triangle_test, sphere_test, box_test, offset);
    const std::string tests = parts.key();
    const std::string own = Watertight::name;
    if (parts.excludes()) {
        if (tests != own)
            return "offset \"" + parts.offset + "\" is built for the tests of \"" + own +
                   "\" alone, not for \"" + tests + "\"; choose methods \"" + own +
                   "\" without other tests, or another offset";
        return strategy == Ctp<Watertight>::name
                   ? ""
                   : "offset \"" + parts.offset + "\" is built for strategy \"ctp\" alone, not for \"" +
                         strategy + "\"; choose strategy \"ctp\" or another offset";
    }
    if (has(bundles, tests)) return "";
    bool offered = false;
    for_each_exchange([&](auto tag) { offered |= tests_key<typename decltype(tag)::type>() == tests; });
    if (!offered)
        return "the tests \"" + tests +
               "\" are not built together; triangle tests are exchanged with sphere test \"" +
               StableSphere::name + "\" and any box test, sphere tests with \"" + WatertightTriangle::name +
               "\" and \"" + PaddedBox::name + "\"";
    return strategy == Ctp<Watertight>::name
               ? ""
               : "the tests \"" + tests +
                     "\" are no bundle's and built for strategy \"ctp\" alone, not for \"" + strategy +
                     "\"; choose strategy \"ctp\", or a bundle without other tests";
}

std::string intersect_methods(const std::string& bundle, const std::string& triangle_test,
                              const std::string& sphere_test, const std::string& box_test,
                              const std::string& offset) {
    const Parts parts = parts_of(bundle, triangle_test, sphere_test, box_test, offset);
    return parts.excludes() ? parts.key() + "+" + parts.offset : parts.key();
}

std::string offset_of(const std::string& bundle, const std::string& offset) {
    return parts_of(bundle, of_bundle, of_bundle, of_bundle, offset).offset;
}

bool methods_exact(const std::string& key) {
    bool exact = false;
    const auto look = [&](auto tag) {
        using Methods = typename decltype(tag)::type;
        if (tests_key<Methods>() == key) exact = Methods::exact;
    };
    for_each_type(MethodBundles{}, look);
    for_each_exchange(look);
    return exact;
}

}  // namespace ctpbench
