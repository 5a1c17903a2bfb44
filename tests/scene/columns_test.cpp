#include "scene/columns.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "wavefront/motley.h"

namespace ctpbench::test {
namespace {

TEST(SceneColumns, HaveTheBytesOfTheirElements) {
    const Scene scene = motley();
    std::map<std::string, std::size_t> bytes;
    for (const SceneColumn& column : columns_of(scene)) bytes[column.name] = column.bytes;
    const std::map<std::string, std::size_t> expected = {{"positions", 9000 * 3 * 4},
                                                         {"triangles", 3000 * 3 * 4},
                                                         {"material_words", 3000 * 4},
                                                         {"texcoords", 3000 * 3 * 2 * 4},
                                                         {"texels", 35 * 4 * 2},
                                                         {"spheres", 60 * 4 * 4},
                                                         {"materials", 6 * sizeof(MaterialDescription)}};
    EXPECT_EQ(bytes, expected);
    for (const SceneColumn& column : columns_of(Scene{})) EXPECT_EQ(column.bytes, 0u) << column.name;
}

}  // namespace
}  // namespace ctpbench::test
