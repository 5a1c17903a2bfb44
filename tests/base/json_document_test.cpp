#include "base/json_document.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "base/error.h"

namespace ctpbench {
namespace {

std::string error_of(std::string_view text) {
    try {
        JsonDocument::parse(text, "t.json");
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        return error.what();
    }
    return "no error";
}

std::string at(const JsonPlace& place) {
    return place.file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column);
}

// `start` carries the place, so the whole beginning of the message is compared.
void expect_error(std::string_view text, const std::string& start) {
    const std::string message = error_of(text);
    EXPECT_EQ(message.substr(0, start.size()), start) << text << "\n" << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST(JsonDocument, KnowsWhereEveryValueAndKeyStarts) {
    const JsonDocument document = JsonDocument::parse(
        "// first\n"
        "{ \"a\" : 1,\n"
        "  \"list\": [10,/* two */ 20 ,-3.5e1// end\n"
        "    , {\"deep\": \"x\\\"]\\\\\"}, true],\n"
        "  \"s/l~t\": null }\n",
        "t.json");
    EXPECT_EQ(at(document.place("")), "t.json:2:1");
    EXPECT_EQ(at(document.key_place("/a")), "t.json:2:3");
    EXPECT_EQ(at(document.place("/a")), "t.json:2:9");
    EXPECT_EQ(at(document.place("/list")), "t.json:3:11");
    EXPECT_EQ(at(document.place("/list/0")), "t.json:3:12");
    EXPECT_EQ(at(document.place("/list/1")), "t.json:3:25");
    EXPECT_EQ(at(document.place("/list/2")), "t.json:3:29");
    EXPECT_EQ(at(document.place("/list/3")), "t.json:4:7");
    EXPECT_EQ(at(document.key_place("/list/3/deep")), "t.json:4:8");
    EXPECT_EQ(at(document.place("/list/3/deep")), "t.json:4:16");
    EXPECT_EQ(at(document.place("/list/4")), "t.json:4:27");
    EXPECT_EQ(at(document.key_place("/s~1l~0t")), "t.json:5:3");
    EXPECT_EQ(at(document.place("/s~1l~0t")), "t.json:5:12");
    EXPECT_EQ(document.value()["list"][3]["deep"], "x\"]\\");
    EXPECT_EQ(document.value()["list"][2], -35.0);
}

TEST(JsonDocument, GivesTheNearestAncestorsPlaceForWhatIsNotWritten) {
    const JsonDocument document = JsonDocument::parse("{\n \"a\": {}}", "t.json");
    EXPECT_EQ(at(document.place("/a/b/c")), "t.json:2:7");
    EXPECT_EQ(at(document.place("/x")), "t.json:1:1");
}

TEST(JsonDocument, CountsColumnsInCharacters) {
    const JsonDocument document = JsonDocument::parse("\xEF\xBB\xBF{\"\xC3\xA9\xE2\x82\xAC\": 1}", "t.json");
    EXPECT_EQ(at(document.place("/\xC3\xA9\xE2\x82\xAC")), "t.json:1:8");
}

TEST(JsonDocument, NamesThePlaceOfSyntaxErrors) {
    expect_error("", "t.json:1:1: error: unexpected end of input");
    expect_error("{\"a\": 1,\n\n", "t.json:3:1: error: unexpected end of input");
    expect_error("{\n \"a\": [1, 2", "t.json:2:12: error: unexpected end of input");
    expect_error("{\"a\": 1,}",
                 "t.json:1:9: error: unexpected '}'; expected string literal; remove the comma");
    expect_error("[1, // c\n]", "t.json:2:1: error: unexpected ']'");
    expect_error("{\"a\": 1\n \"b\": 2}",
                 "t.json:2:2: error: unexpected string literal; expected '}'; put a comma");
    expect_error("{\"a\" 1}", "t.json:1:6: error: unexpected number literal; expected ':'; put a colon");
    expect_error("{'a': 1}", "t.json:1:2: error: invalid literal; text and keys go in double quotes");
    expect_error("{\"a\": True}", "t.json:1:7: error: invalid literal");
    expect_error("{\"a\": tru}", "t.json:1:10: error: invalid literal");
    expect_error("{\"a\": NaN}", "t.json:1:7: error: invalid literal");
    expect_error("{\"a\": 1.}", "t.json:1:9: error: invalid number");
    expect_error("{\"a\": 1e999}", "t.json:1:7: error: number overflow");
    expect_error("{\"a\": \"x\n\"}", "t.json:1:9: error: invalid string");
    expect_error("{\"a\": \"x\\q\"}", "t.json:1:10: error: invalid string");
    expect_error("{\"a\": \"\xFF\"}", "t.json:1:8: error: invalid string");
    expect_error("{}}", "t.json:1:3: error: unexpected '}'; expected end of input");
    expect_error("{} {}", "t.json:1:4: error: unexpected '{'; expected end of input; remove what follows");
    expect_error("{} /* open", "t.json:1:11: error: invalid comment");
    expect_error(std::string_view("{}\0{", 4), "t.json:1:3: error: a zero byte");
}

TEST(JsonDocument, RefusesDuplicateKeysAllAtOnce) {
    EXPECT_EQ(error_of("{\"a\": {\"x\": 1},\n \"b\": 2,\n \"a\": {\"x\": 2}, \"b\": 3}"),
              "t.json:3:2: error: /a: the key is here twice, first in line 1; remove one of the two\n"
              "t.json:3:17: error: /b: the key is here twice, first in line 2; remove one of the two");
    EXPECT_EQ(error_of("{\"a\": {\"x\": 1}, \"b\": {\"x\": 1}}"), "no error");
}

TEST(JsonDocument, BoundsNestingAndSize) {
    const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
    EXPECT_EQ(error_of(nested(JsonDocument::max_depth)), "no error");
    expect_error(nested(JsonDocument::max_depth + 1), "t.json:1:65: error: nested deeper than 64 levels");
    expect_error(std::string(1'000'000, '['), "t.json:1:65: error: nested deeper than 64 levels");
    expect_error(std::string(JsonDocument::max_bytes + 1, ' '), "t.json:1:1: error: larger than 1024 KiB");
}

// Each value keeps the keys down to it: half a megabyte of key above a quarter of a million values would be
// 100 GB.
TEST(JsonDocument, BoundsTheKeysDownToAValue) {
    const auto keyed = [](std::size_t bytes) { return "{\"" + std::string(bytes, 'k') + "\": [1, 2]}"; };
    EXPECT_EQ(error_of(keyed(JsonDocument::max_pointer - 1)), "no error");
    expect_error(keyed(JsonDocument::max_pointer),
                 "t.json:1:2: error: the keys down to here have more than 512");
    const std::string half(300, 'k');
    expect_error("{\"" + half + "\":\n {\"" + half + "\": 1}}", "t.json:2:3: error: the keys down to here");
}

TEST(JsonDocument, TellsTheFirstErrorsAlone) {
    std::string text = "{\"a\": 1";
    for (std::size_t i = 0; i < 60'000; ++i) text += ", \"a\": 1";
    const std::string errors = error_of(text + "}");
    EXPECT_EQ(static_cast<std::size_t>(std::count(errors.begin(), errors.end(), '\n')) + 1,
              JsonDocument::max_errors);
}

TEST(JsonDocument, LoadsFilesAndNamesTheFileThatItCannot) {
    const auto path = std::filesystem::path(testing::TempDir()) / "json_document_test.json";
    std::ofstream(path) << "{\"a\": 7}\n";
    EXPECT_EQ(JsonDocument::load(path).value()["a"], 7);
    std::filesystem::remove(path);
    for (const std::filesystem::path& wrong : {path, std::filesystem::path(testing::TempDir())}) {
        try {
            JsonDocument::load(wrong);
            ADD_FAILURE() << wrong;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::usage);
            EXPECT_TRUE(std::string(error.what()).starts_with(wrong.string() + ": error: ")) << error.what();
        }
    }
}

TEST(JsonDocument, SetChangesValuesAndRemembersTheOption) {
    JsonDocument document = JsonDocument::parse("{\"a\": {\"b\": [1, 2]}, \"c\": 1}", "t.json");
    document.set("/a/b/1=20");
    document.set("/a/b/-=30");
    document.set("/a/new={\"x\": [true]}");
    document.set("/c=some text = more");
    EXPECT_EQ(
        document.value(),
        nlohmann::json::parse(R"({"a": {"b": [1, 20, 30], "new": {"x": [true]}}, "c": "some text = more"})"));
    EXPECT_EQ(at(document.place("/a/b/0")), "t.json:1:14");
    EXPECT_EQ(error_line(document.place("/a/b/1"), "m"), "--set /a/b/1=20: error: m");
    EXPECT_EQ(error_line(document.place("/a/b/2"), "m"), "--set /a/b/-=30: error: m");
    EXPECT_EQ(error_line(document.place("/a/new/x/0"), "m"), "--set /a/new={\"x\": [true]}: error: m");
    document.set("/a=5", "--a 5");
    EXPECT_EQ(error_line(document.place("/a/b/0"), "m"), "--a 5: error: m");
}

TEST(JsonDocument, SetRefusesWhatItCannotReach) {
    const auto error_of_set = [](std::string_view edit) -> std::string {
        JsonDocument document = JsonDocument::parse("{\"a\": {\"b\": [1, 2]}, \"c\": 1}", "t.json");
        try {
            document.set(edit);
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::usage);
            return error.what();
        }
        return "no error";
    };
    EXPECT_EQ(error_of_set("/x/y=1"),
              "--set /x/y=1: error: t.json has no /x; set that first, or write it there");
    EXPECT_NE(error_of_set("/c/d=1").find("neither an object nor a list"), std::string::npos);
    EXPECT_NE(error_of_set("/a/b/2=1").find("/a/b has 2 elements"), std::string::npos);
    for (const char* edit : {"", "c=1", "/c", "=", "/a/b/x=1", "/a/b/01=1", "/a/b/-1=1", "/~=1", "/a/b/-/x=1",
                             "/a/b/99999999999999999999=1"}) {
        EXPECT_TRUE(error_of_set(edit).starts_with("--set " + std::string(edit) + ": error: ")) << edit;
    }
    EXPECT_EQ(error_of_set("/=1"), "no error");  // the key may be empty
}

}  // namespace
}  // namespace ctpbench
