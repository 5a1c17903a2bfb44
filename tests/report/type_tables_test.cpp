// narrowing.csv and types.csv: who is compared with whom, and what the ratios are of.
#include "report/type_tables.h"

#include <gtest/gtest.h>

namespace ctpbench {
namespace {

CellResult cell(const std::string& strategy, const std::string& types, const std::string& shade = no_shade) {
    CellResult c;
    c.workload = {"room", 0, 0.03, "quality"};
    c.contender.backend = "cpu", c.contender.strategy = strategy;
    c.contender.traversal = "single", c.contender.methods = "watertight";
    c.contender.types = types, c.contender.shade = shade;
    c.scene_source = "mesh", c.triangles = 12, c.valid = true;
    return c;
}

Results of(std::vector<CellResult> cells) {
    Results results;
    results.cells = std::move(cells);
    SceneResult& scene = results.scenes.emplace_back();
    scene.name = "room";
    scene.needs = {1, 1u << material_type<Matte> | 1u << material_type<Plastic>, true};
    return results;
}

TEST(NarrowingTable, SetsEachContenderBesideItselfWithAllTypes) {
    CellResult all = cell("ctp", "all"), scene = cell("ctp", "scene");
    all.layout_bytes = 48, scene.layout_bytes = 40;
    for (const double speed : {10.0, 20.0, 30.0}) {
        all.add("intersect", 1, speed, 1.0);
        scene.add("intersect", 1, 1.5 * speed, 1.0);
    }
    CellResult shade_all = cell("restart", "all", "sort"), shade = cell("restart", "scene", "sort");
    for (int round = 0; round < 3; ++round) {
        shade_all.add("intersect", 1, 1.0, 1.0), shade.add("intersect", 1, 7.0, 1.0);
        shade_all.add("shade", 1, 4.0, 1.0), shade.add("shade", 1, 5.0, 1.0);
    }
    CellResult rejected = cell("oop", "scene");
    rejected.valid = false;
    EXPECT_EQ(narrowing_csv(of({all, scene, shade_all, shade, rejected, cell("oop", "all"),
                                cell("typed_leaves", "scene")})),
              "scene,scene_source,triangles,spheres,backend,kernel,strategy,types,all_mrays_s,scene_mrays_s,"
              "gain,gain_lo,gain_hi,all_bytes,scene_bytes\r\n"
              "room,mesh,12,0,cpu,intersect,ctp,triangle,20,30,1.5,1.5,1.5,48,40\r\n"
              "room,mesh,12,0,cpu,shade,sort,\"matte+plastic, textured\",4,5,1.25,1.25,1.25,,\r\n");
}

TEST(TypesTable, ComparesWithCtpOfOneType) {
    CellResult one = cell("ctp", "synthetic_1"), eight = cell("restart", "synthetic_64_using_8");
    for (const double s : {1.0, 2.0, 3.0}) {
        one.add("intersect", 100, 6.0 / s, s);
        eight.add("intersect", 100, 3.0 / s, 2.0 * s);
    }
    EXPECT_EQ(
        types_csv(of({one, eight, cell("ctp", "all")})),
        "scene,scene_source,triangles,backend,kernel,strategy,listed,used,large,median_mrays_s,lo_mrays_s,"
        "hi_mrays_s,ratio,ratio_lo,ratio_hi\r\n"
        "room,mesh,12,cpu,intersect,ctp,1,1,none,3,2,6,1,1,1\r\n"
        "room,mesh,12,cpu,intersect,restart,64,8,none,1.5,1,3,0.5,0.5,0.5\r\n");
}

// What stands between two intersects is one thing: sorting pays for its shading.
TEST(TypesTable, AddsUpTheStagesOfAFrame) {
    CellResult ctp = cell("ctp", "synthetic_1", "ctp"),
               sort = cell("ctp", "synthetic_8_large_unused", "sort");
    for (int round = 0; round < 3; ++round) {
        ctp.add("intersect", 90, 90e-6 / 6.0, 6.0), ctp.add("shade", 90, 90e-6 / 2.0, 2.0);
        ctp.add("compact", 90, 90e-6, 1.0), ctp.add("copy", 90, 90e-6, 1.0);
        sort.add("intersect", 90, 90e-6 / 6.0, 6.0), sort.add("sort", 90, 90e-6 / 3.0, 3.0);
        sort.add("shade", 90, 90e-6, 1.0), sort.add("compact", 90, 90e-6 / 2.0, 2.0);
    }
    const std::string text = types_csv(of({ctp, sort}));
    for (const char* line : {"cpu,shade,ctp,1,1,none,4.5e-05,4.5e-05,4.5e-05,1,1,1",
                             "cpu,shade,sort,8,7,unused,9e-05,9e-05,9e-05,2,2,2",
                             "cpu,sort+shade+compact,sort,8,7,unused,1.5e-05,1.5e-05,1.5e-05,0.5,0.5,0.5",
                             "cpu,frame,sort,8,7,unused,7.5e-06,7.5e-06,7.5e-06,0.75,0.75,0.75"})
        EXPECT_NE(text.find(line), std::string::npos) << line << " is not in\n" << text;
}

}  // namespace
}  // namespace ctpbench
