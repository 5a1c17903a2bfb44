#include "report/csv_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "report/csv.h"

namespace ctpbench {
namespace {

std::string error_of(const std::string& text, const std::string& column = "") {
    try {
        const CsvTable table = CsvTable::parse(text, "t.csv");
        if (!column.empty()) table.number(0, table.column(column));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        return error.what();
    }
    return "no error";
}

TEST(CsvTable, ReadsWhatIsWritten) {
    const std::vector<std::string> awkward = {"a,b",   "say \"x\"", "two\nlines", "",
                                              "plain", "\"",        "cr\rlf\r\n"};
    const CsvTable table =
        CsvTable::parse(csv_line({"a", "b", "c", "d", "e", "f", "g"}) + csv_line(awkward), "t.csv");
    ASSERT_EQ(table.lines(), 1u);
    for (std::size_t i = 0; i < awkward.size(); ++i) EXPECT_EQ(table.field(0, i), awkward[i]) << i;
}

TEST(CsvTable, TakesBothLineEndsAndNoneAtTheEnd) {
    for (const char* text : {"x,y\n1,2\n3,", "x,y\r\n1,2\r\n3,\r\n"}) {
        const CsvTable table = CsvTable::parse(text, "t.csv");
        ASSERT_EQ(table.lines(), 2u);
        EXPECT_EQ(table.number(0, table.column("y")), 2.0);
        EXPECT_TRUE(std::isnan(table.number(1, table.column("y"))));
    }
}

TEST(CsvTable, NamesThePlaceOfAnError) {
    EXPECT_EQ(error_of("x,y\n1,2\n\"3\n\",4\n5\n").substr(0, 30), "t.csv:5: error: 1 fields where");
    EXPECT_EQ(error_of("x\n\"1\n").substr(0, 22), "t.csv:2: error: a quot");
    EXPECT_EQ(error_of("").substr(0, 20), "t.csv:1: error: no l");
    EXPECT_EQ(error_of("x\none\n", "x"), "t.csv:2: error: column \"x\" holds \"one\", which is no number");
    EXPECT_NE(error_of("x\n1\n", "y").find("no column \"y\""), std::string::npos);
    EXPECT_THROW(CsvTable::load("/nonexistent/rows.csv"), Error);
}

TEST(CsvTable, WhatMayNeverEndIsNotRead) {
    EXPECT_THROW(CsvTable::load("/dev/zero"), Error);
    EXPECT_THROW(CsvTable::load(testing::TempDir()), Error);
}

}  // namespace
}  // namespace ctpbench
