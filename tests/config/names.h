// Names for tests that do not care which ones the program really has.
#pragma once

#include <string>

#include "base/json_document.h"
#include "config/cells.h"
#include "config/config.h"
#include "wavefront/interleaved/intersector.h"
#include "wavefront/type_choice.h"

namespace ctpbench {

// Those that need nothing but the reader.
inline KnownNames reader_names() {
    KnownNames known;
    known.strategies = {"ctp", "std_variant", "oop", "oop_arena", "restart", "typed_leaves", "typed_phases"};
    known.yardsticks = {{"embree_robust", "cpu"}, {"embree_default", "cpu"}, {"while_while", "cuda"}};
    for (const char* call : {"embree_16", "embree_16_coherent", "embree_stream", "embree_stream_coherent"})
        for (const char* mode : {"", "_robust"})
            known.yardsticks.push_back({std::string(call) + mode, "cpu"});
    known.traversals = {"single", "interleaved"};
    known.types = {"scene", "all", "synthetic_1"};
    known.methods = {"watertight", "paper", "fast", "float64"};
    known.builders = {"quality", "paper"};
    known.triangle_tests = {"woop", "moeller_trumbore", "pluecker", "baldwin_weber", "moeller_trumbore_f64"};
    known.sphere_tests = {"stable", "textbook", "stable_f64"};
    known.box_tests = {"padded", "plain", "ize"};
    known.offsets = {"waechter_binder", "constant_epsilon", "relative_epsilon", "exclude_id"};
    known.stress = {{"edges", {"triangle", "box"}}, {"far_spheres", {"sphere"}}, {"leaving", {"offset"}}};
    known.shades = {"ctp", "std_variant", "oop", "oop_arena", "sort", "sort_restored", "queues"};
    return known;
}

inline KnownNames test_names() {
    KnownNames known = reader_names();
    known.types = type_choices();
    known.available = [](const Contender& c) { return traverses(c.strategy, c.traversal, c.backend); };
    return known;
}

inline Config config_of(const std::string& text) {
    return read_config(JsonDocument::parse(text, "t.json"), test_names());
}

}  // namespace ctpbench
