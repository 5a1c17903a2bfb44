// scripts/report on runs, whole, old and damaged: what the page says, that it stands alone, that a browser
// shows it.
#include "run_plot.h"

namespace ctpbench::test {
namespace {

const char* kMeta = R"({"schema_version": 1, "run_id": "x-20260102T030405Z", "state": "complete",
    "command": "ctpbench --set '/seed=2'", "threads": 2, "isa": "avx2", "notices": [],
    "config": {"description": "A room", "rounds": 9, "measure": true, "study": "speed"},
    "machine": {"cpu": "Z80", "cores": 1, "isa_flags": "fpu avx avx2 fma"},
    "build": {"build_type": "Release", "compiler": "GNU 12", "git_commit": "0123456789abcdef", "git_dirty": false},
    "scenes": [{"name": "room", "source": "mesh", "triangles": 12}]})";
const char* kSummary =
    "scene,scene_source,triangles,spheres,backend,strategy,kernel,median_mrays_s,lo_mrays_s,hi_mrays_s,"
    "valid\n"
    "room,mesh,12,0,cpu,ctp,intersect,2,1.5,2.5,true\n";
const char* kTable3 =
    "# Table 3: intersect throughput\n\nOurs are `medians`\nover rounds.\n\n"
    "## room<b>&, cpu (mesh, 12 triangles)\n\n"
    "| spheres | ctp: paper | ctp | ctp/oop: paper | ctp/oop |\n"
    "| --- | --- | --- | --- | --- |\n"
    "| 10 | 4.56 | 1.43 | 1.17 | 1.31 [1.20, 1.48] |\n\n"
    "## hall, cpu (stand-in, 12 triangles)\n\n"
    "| spheres | ctp: paper | ctp | ctp/oop: paper | ctp/oop |\n"
    "| --- | --- | --- | --- | --- |\n"
    "| 10 | n/a | 1.25 | n/a | n/a |\n";

class Report : public PlotTest {
protected:
    Outcome report(const std::string& arguments) const { return run_script("scripts/report", arguments); }
    std::string page() const { return read(folder_ / "report.html"); }
    void make(const std::string& arguments) const {
        const Outcome outcome = report(arguments);
        ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
        EXPECT_EQ(outcome.output, "report.html\n");
    }
    void expect_said(const std::string& words) const {
        EXPECT_NE(page().find(words), std::string::npos) << words;
    }
    void expect_unsaid(const std::string& words) const {
        EXPECT_EQ(page().find(words), std::string::npos) << words;
    }
    void expect_sound() const {
        const Outcome outcome = run_script("tests/program/page_structure.py", "report.html");
        EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    }
    // The last of a test, which it skips where there is no browser.
    void expect_shown_by_browser() const {
        if (run_shell("command -v chromium").exit_code != 0)
            GTEST_SKIP() << "opens no page, since there is no chromium: apt-get install chromium";
        const Outcome outcome = run_script("tests/program/page_in_browser.py", "report.html");
        EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    }
    // What is wrong with the folder r.
    void expect_damage(const std::string& reason) const {
        expect_refusal(report("r"), reason);
        EXPECT_FALSE(std::filesystem::exists(folder_ / "report.html")) << reason;
    }
    void SetUp() override {
        PlotTest::SetUp();
        std::filesystem::create_directories(folder_ / "r");
    }
};

TEST_F(Report, OfASmokeRunIsShownByABrowser) {
    const Outcome outcome =
        run("--quiet --config $C/smoke.json --set '/description=\"A & b\"' --rounds 2 --out $D/smoke");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    make("smoke");
    for (const char* words :
         {"Table 1 of the paper", "Table 2 of the paper", "Table 3 of the paper",
          "Figure 4: accumulated time", "Rounds: 2.", "Stand-ins: smoke.", "the paper has no figures for it",
          "What the oracle said", "smoke: A &amp; b",
          "--set &#x27;/description=&quot;A &amp; b&quot;&#x27; --rounds 2", "How to read this page"})
        expect_said(words);
    expect_sound();
    expect_shown_by_browser();
}

// Among them what older programs wrote, runs without rows and one without any table.
TEST_F(Report, OfManyRunsIsAGallery) {
    std::string folders;
    for (const char* folder :
         {"epyc-turin-2c/peers_avx2", "epyc-turin-2c/profile", "epyc-turin-2c/stability",
          "epyc-genoa-2c/table2", "epyc-genoa-2c/triangles", "2026-11-26-h100/table3_conference"})
        folders += std::string(" '" CTPBENCH_SOURCE_DIR "/results/") + folder + "'";
    make(folders);
    for (const char* words : {"The runs on this page", "ctpbench: 6 runs", "There is no rows.csv",
                              "There is no table2.md", "NVIDIA H100", "Cycles of rays in flight",
                              "Failures of each method", "ratio to the yardstick", ">Paper</th>"})
        expect_said(words);
    expect_sound();
    expect_shown_by_browser();
}

TEST_F(Report, SetsThePapersFiguresApartFromOurs) {
    write("r/meta.json", kMeta);
    write("r/table3.csv", "spheres,room/cpu/ctp\n10,1.43\n");
    write("r/table3.md", kTable3);
    make("r");
    for (const char* words :
         {"colspan=\"1\" class=\"first\">Paper</th>", "colspan=\"1\" class=\"first\">Measured</th>",
          "colspan=\"2\" class=\"first\">Ratios</th>", "ctp/<wbr />oop, paper", "ctp/<wbr />oop, ours",
          "<td class=\"first\">4.56</td>", "1.31 [1.20, 1.48]", "room&lt;b&gt;&amp;, cpu",
          "<code>medians</code> over rounds", "by spheres; the paper has no figures for it"})
        expect_said(words);
    expect_unsaid("room<b>");
    expect_unsaid("hall, cpu (stand-in, 12 triangles), by spheres</");
    expect_sound();
}

TEST_F(Report, SaysWhereAndHowToRunAgain) {
    write("r/meta.json", kMeta);
    write("r/summary.csv", kSummary);
    make("r");
    for (const char* words : {"Z80", "avx, avx2, fma", "GNU 12", "2026-01-02 03:04 UTC", "r: A room",
                              "git checkout 0123456789abcdef\nctpbench --set &#x27;/seed=2&#x27;",
                              "2.00 [1.50, 2.50]", "scripts/report r"})
        expect_said(words);
    for (const char* words : {"class=\"Warning\"", "fpu"}) expect_unsaid(words);
}

TEST_F(Report, WarnsOfWhatMakesARunDoubtful) {
    write("r/meta.json", R"({"schema_version": 7, "state": "interrupted", "notices":
        ["room/0/oop: rejected: 3 misses", "the mesh has a hole"],
        "config": {"rounds": 3, "measure": true, "study": "speed"},
        "build": {"build_type": "Debug", "git_commit": "fedcba9876543210", "git_dirty": true},
        "scenes": [{"name": "hall_like", "source": "stand-in"}]})");
    write("r/summary.csv", std::string(kSummary) + "room,mesh,12,0,cpu,restart,intersect,2,1,3,unchecked\n");
    make("r");
    for (const char* words :
         {"schema version 7", "The run is interrupted", "commit fedcba987654 with changes",
          "Build type Debug", "Rounds: 3.", "Stand-ins: hall_like.",
          "Left out of every table and chart: room/0/oop: rejected: 3 misses",
          "No oracle has checked the hits of room/0/restart.",
          "<strong class=\"Note\">Note: </strong>the mesh has a hole"})
        expect_said(words);
    expect_sound();
    std::filesystem::remove(folder_ / "r/meta.json");
    write("r/summary.csv", std::string(kSummary) + "room,mesh,12,0,cpu,oop,intersect,2,1,3,false\n");
    make("r");
    expect_said("There is no meta.json");
    expect_said(
        "Rejected, since the hits are not the oracle&#x27;s, and left out of every table and chart: "
        "room/0/oop.");
    expect_sound();
}

TEST_F(Report, DrawsWhatItCanOfOlderRuns) {
    write("r/meta.json", kMeta);
    write("r/summary.csv", kSummary);
    write("r/peers.csv", "scene,rays,threads\nroom,primary,2\n");
    make("r");
    expect_said("No chart of peers.csv: r/peers.csv: no column contender");
    expect_sound();
}

// All that is wrong with any of the folders is said at once, and no page is made.
TEST_F(Report, RefusesWhatIsNoRunOrDamaged) {
    for (const char* name : {"empty", "short", "cut", "long", "cut_meta", "other_meta", "odd_meta"})
        std::filesystem::create_directories(folder_ / name);
    write("short/rows.csv", "run_id,scene\nx,room\nx\n");
    write("cut/rows.csv", "run_id,scene\nx,room\nx,ro");
    write("long/rows.csv", "run_id,scene\nx,room,y\n");
    write("cut_meta/rows.csv", "run_id,scene\nx,room\n");
    write("cut_meta/meta.json", "{\n\"state\": ");
    write("other_meta/rows.csv", "run_id,scene\nx,room\n");
    write("other_meta/meta.json", "[]");
    write("odd_meta/rows.csv", "run_id,scene\nx,room\n");
    write("odd_meta/meta.json", R"({"notices": "none", "scenes": [{"name": 3}], "machine": []})");
    const Outcome outcome = report("nowhere empty short cut long cut_meta other_meta odd_meta");
    for (const char* reason :
         {"nowhere: no such folder; name the folder that a run left",
          "empty: holds neither rows.csv nor figure4.csv", "short/rows.csv:3: fewer fields than columns",
          "cut/rows.csv:3: the file ends within this line; run the experiment again",
          "long/rows.csv:2: more fields than columns", "cut_meta/meta.json:2:10: is not JSON",
          "other_meta/meta.json: is not a JSON object",
          "odd_meta/meta.json: /notices is not a list; /scenes/0/name is not a string; run"})
        expect_refusal(outcome, std::string("report: error: ") + reason);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "report.html"));
}

TEST_F(Report, RefusesTablesAndPicturesThatAreDamaged) {
    write("r/table3.csv", "spheres,room/cpu/ctp\n10,fast\n");
    expect_damage("r/table3.csv:2: room/cpu/ctp is \"fast\"");
    write("r/table3.csv", "spheres,room/cpu/ctp\n10,1\n");
    write("r/table3.md", "# T\n\n## s\n\n| a | b |\n| --- | --- |\n| 1 |\n");
    expect_damage("r/table3.md:7: 1 cells under 2 headings");
    write("r/table3.md", kTable3);
    write("r/room-0.exr", "not a picture");
    write("r/room-0.png", "not a picture");
    expect_damage("r/room-0.png: cannot be read");
}

TEST_F(Report, SaysWhereItCannotWrite) {
    write("r/summary.csv", kSummary);
    const Outcome outcome = report("r --out r/summary.csv/page.html");
    EXPECT_EQ(outcome.exit_code, 8) << outcome.output;
    EXPECT_NE(outcome.output.find("name another file with --out"), std::string::npos) << outcome.output;
}

#ifdef CTPBENCH_HAS_OPENIMAGEIO
// A contender whose picture differs has one of its own, and what tells it from the first is shown; of the
// same run once more it is said that nothing does.
TEST_F(Report, ShowsWhatTellsPicturesApart) {
    if (std::system("/usr/bin/python3 -c 'import OpenImageIO' 2>/dev/null") != 0)
        GTEST_SKIP() << "needs OpenImageIO for /usr/bin/python3: apt-get install python3-openimageio";
    write("c.json",
          R"({"schema_version": 1, "experiment": "x", "width": 96, "height": 64, "bounces": 3, "rounds": 1,
        "images": true, "tables": [], "reference": "ctp", "matrix": {"scene": "smoke", "spheres": 20,
        "strategy": "ctp", "shade": ["ctp", "oop"], "bounce_limit": [0, 2]}})");
    for (const char* name : {"a", "b"}) {
        const Outcome outcome = run(std::string("--quiet --config $D/c.json --out $D/") + name);
        ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
    }
    // Two pictures of four contenders: those of one bounce limit are the same.
    std::size_t pictures = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / "a"))
        pictures += entry.path().extension() == ".exr";
    EXPECT_EQ(pictures, 2u);
    make("a b");
    for (const char* words :
         {"Rendered picture: smoke-20, first contender, a", "Rendered picture: smoke-20, ctp+ctp-limit2, b",
          "Difference image: smoke-20, ctp+ctp-limit2, a minus smoke-20, first contender, a: Orange where",
          "smoke-20, first contender, b minus smoke-20, first contender, a: The same bit for bit."})
        expect_said(words);
    expect_unsaid("Difference image: smoke-20, first contender, b");
    // A limit of two bounces loses light.
    EXPECT_NE(page().find("on the whole by -"), std::string::npos);
    expect_sound();
}
#endif

}  // namespace
}  // namespace ctpbench::test
