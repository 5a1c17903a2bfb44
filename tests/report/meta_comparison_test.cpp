#include "report/meta_comparison.h"

#include <nlohmann/json.hpp>

#include "tests/scene/files.h"

namespace ctpbench {
namespace {

using MetaComparison = SceneFiles;

std::string nested(std::size_t levels) { return std::string(levels, '[') + std::string(levels, ']'); }

// A comparison goes down level by level, and the stack with it.
TEST_F(MetaComparison, WhatIsNestedWithoutEndIsLeftOut) {
    write("a/meta.json", "{\"threads\": 2, \"config\": " + nested(1'000'000) + "}");
    write("b/meta.json", "{\"threads\": 3, \"config\": " + nested(20) + "}");
    const auto a = read_meta(folder / "a"), b = read_meta(folder / "b");
    EXPECT_EQ(b.at("config").dump(), nested(20));
    const auto lines = differences(a, b);
    EXPECT_NE(std::find(lines.begin(), lines.end(), "/threads: 2 there, 3 here"), lines.end());
}

}  // namespace
}  // namespace ctpbench
