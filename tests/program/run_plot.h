// Runs scripts/plot in a test's folder; skips where this machine cannot draw.
#pragma once

#include <cstdlib>
#include <initializer_list>
#include <string>

#include "run_program.h"

namespace ctpbench::test {

class PlotTest : public ProgramTest {
protected:
    void SetUp() override {
        ProgramTest::SetUp();
        if (std::system("/usr/bin/python3 -c 'import matplotlib' 2>/dev/null") != 0)
            GTEST_SKIP() << "needs matplotlib for /usr/bin/python3: apt-get install python3-matplotlib";
    }
    // `name`: from the root of the repository.
    Outcome run_script(const std::string& name, const std::string& arguments) const {
        return run_shell("cd '" + folder_.string() + "'; '" CTPBENCH_SOURCE_DIR "/" + name + "' " +
                         arguments);
    }
    Outcome plot(const std::string& arguments) const { return run_script("scripts/plot", arguments); }
    void expect_refused(const std::string& arguments, const std::string& reason) const {
        expect_refusal(plot(arguments), reason);
    }
    static void expect_refusal(const Outcome& outcome, const std::string& reason) {
        EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
        EXPECT_NE(outcome.output.find(reason), std::string::npos) << outcome.output;
        EXPECT_EQ(outcome.output.find("Traceback"), std::string::npos) << outcome.output;
    }
    void expect_chart(const std::string& name) const {
        EXPECT_EQ(read(folder_ / (name + ".png")).substr(1, 3), "PNG") << name;
        EXPECT_NE(read(folder_ / (name + ".svg")).find("</svg>"), std::string::npos) << name;
        EXPECT_TRUE(std::filesystem::exists(folder_ / (name + "_data.csv"))) << name;
    }
    // Of charts that the folder's files give.
    void expect_same_bytes_again(std::initializer_list<std::string> names) const {
        ASSERT_EQ(plot(". --out a").exit_code, 0);
        ASSERT_EQ(plot(". --out b").exit_code, 0);
        for (const std::string& name : names)
            for (const char* end : {".svg", ".png", "_data.csv"})
                EXPECT_TRUE(read(folder_ / "a" / (name + end)) == read(folder_ / "b" / (name + end)))
                    << name << end;
    }
    // The SVG's description holds these words.
    void expect_words(const std::string& name, const std::string& words) const {
        const std::string svg = read(folder_ / (name + ".svg"));
        EXPECT_NE(svg.find(words), std::string::npos)
            << "no \"" << words << "\" in " << svg.substr(0, svg.find("<defs>"));
    }
};

}  // namespace ctpbench::test
