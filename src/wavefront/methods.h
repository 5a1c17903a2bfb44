// The methods that runs may choose from, by name, and which of them go together. A choice is a bundle and,
// for each of its parts, what to use in place of the bundle's own: of_bundle keeps that.
#pragma once

#include <string>
#include <vector>

namespace ctpbench {

struct MethodsInfo {
    std::string name;
    std::string triangle_test, sphere_test, box_test, offset;  // the names of its parts
    bool exact;                                                // hits are bit-identical whatever the tree
};
// The default first, in all of these.
std::vector<MethodsInfo> method_bundles();
std::vector<std::string> triangle_tests();
std::vector<std::string> sphere_tests();
std::vector<std::string> box_tests();
std::vector<std::string> offsets();

// Why there is no contender of this strategy with these methods, and what to choose instead; empty if there
// is one. Any of the names may be unknown.
std::string methods_obstacle(const std::string& strategy, const std::string& bundle,
                             const std::string& triangle_test, const std::string& sphere_test,
                             const std::string& box_test, const std::string& offset);

// What make_intersector() and make_device_intersector() call a choice that has no obstacle: the name of the
// bundle that has these tests, else the names of the tests joined by `+`. Methods that leave out a primitive,
// for the offset `exclude_id`, have a key of their own.
std::string intersect_methods(const std::string& bundle, const std::string& triangle_test,
                              const std::string& sphere_test, const std::string& box_test,
                              const std::string& offset);

// The offset's name, as make_shader() takes it, of a choice that has no obstacle.
std::string offset_of(const std::string& bundle, const std::string& offset);

// Whether hits of the methods with this key are bit-identical whatever the tree. False for unknown keys, as
// for what is not ours.
bool methods_exact(const std::string& key);

}  // namespace ctpbench
