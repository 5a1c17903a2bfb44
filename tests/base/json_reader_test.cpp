#include "base/json_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "base/error.h"

namespace ctpbench {
namespace {

// The error that `read` collects from the text, or "no error".
template <class Read>
std::string error_of(std::string_view text, Read read) {
    JsonReader reader(JsonDocument::parse(text, "t.json"));
    read(reader.root());
    try {
        reader.finish();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        return error.what();
    }
    return "no error";
}

TEST(JsonReader, ReadsEveryType) {
    bool flag = false;
    std::int32_t small = 0;
    std::int64_t large = 0;
    std::uint64_t huge = 0;
    float single = 0;
    double real = 0;
    std::string text, mode;
    Vec3 vector{};
    std::vector<int> numbers;
    std::string names;
    const std::string error = error_of(
        R"({"flag": true, "small": -7, "large": -9000000000, "huge": 18446744073709551615, "single": 0.5,
            "real": 3, "text": "t", "mode": "fast", "vector": [1, 2.5, -3], "numbers": [1, 2, 3],
            "map": {"x": {"value": 1}, "y": {"value": 2}}})",
        [&](const JsonObject& root) {
            EXPECT_TRUE(root.get("flag", flag));
            root.get("small", small);
            root.get("large", large);
            root.get("huge", huge);
            root.get("single", single);
            root.get("real", real, range(0, 3));
            root.require("text", text);
            root.require("mode", mode, std::vector<std::string>{"fast", "exact"});
            root.get("mode", mode, {"fast", "exact"});
            root.get("vector", vector);
            for (const JsonValue& element : root.list("numbers")) element.read(numbers.emplace_back());
            for (const auto& [name, value] : root.object("map").members()) {
                int number = 0;
                EXPECT_TRUE(value.object().get("value", number));
                names += name + std::to_string(number);
            }
        });
    EXPECT_EQ(error, "no error");
    EXPECT_TRUE(flag);
    EXPECT_EQ(small, -7);
    EXPECT_EQ(large, -9'000'000'000);
    EXPECT_EQ(huge, 18'446'744'073'709'551'615u);
    EXPECT_EQ(single, 0.5f);
    EXPECT_EQ(real, 3.0);
    EXPECT_EQ(text + mode, "tfast");
    EXPECT_EQ(vector, (Vec3{1, 2.5f, -3}));
    EXPECT_EQ(numbers, (std::vector<int>{1, 2, 3}));
    EXPECT_EQ(names, "x1y2");
}

TEST(JsonReader, LeavesDefaultsWhereNothingIsWritten) {
    int width = 5;
    Vec3 eye{1, 2, 3};
    const std::string error = error_of("{}", [&](const JsonObject& root) {
        EXPECT_FALSE(root.get("width", width));
        EXPECT_FALSE(root.has("width"));
        const JsonObject camera = root.object("camera");
        EXPECT_FALSE(camera.get("eye", eye));
        EXPECT_FALSE(camera.require("eye", eye));  // the camera itself is optional
        EXPECT_TRUE(root.list("files").empty());
        EXPECT_TRUE(root.object("map").members().empty());
    });
    EXPECT_EQ(error, "no error");
    EXPECT_EQ(width, 5);
    EXPECT_EQ(eye, (Vec3{1, 2, 3}));
}

TEST(JsonReader, ReportsWrongTypesWithWhatWasFound) {
    bool flag = false;
    int number = 1;
    float real = 1;
    std::string text;
    Vec3 vector{};
    const std::string error = error_of(
        "{\"flag\": 1,\n\"number\": 1e-3,\n\"real\": \"1\",\n\"text\": null,\n\"vector\": [1, 2],\n"
        "\"vector2\": [1, \"y\", false],\n\"object\": [3],\n\"list\": {}}",
        [&](const JsonObject& root) {
            root.get("flag", flag);
            root.get("number", number);
            root.get("real", real);
            root.get("text", text);
            root.get("vector", vector);
            root.get("vector2", vector);
            root.object("object");
            root.list("list");
        });
    EXPECT_EQ(error,
              "t.json:1:10: error: /flag: expected true or false, found 1\n"
              "t.json:2:11: error: /number: expected an integer, found 0.001\n"
              "t.json:3:9: error: /real: expected a number, found \"1\"\n"
              "t.json:4:9: error: /text: expected text in double quotes, found null\n"
              "t.json:5:11: error: /vector: expected a list of three numbers, found a list of 2\n"
              "t.json:6:16: error: /vector2/1: expected a number, found \"y\"\n"
              "t.json:6:21: error: /vector2/2: expected a number, found false\n"
              "t.json:7:11: error: /object: expected an object, found a list of 1\n"
              "t.json:8:9: error: /list: expected a list, found an object");
    EXPECT_EQ(vector, (Vec3{0, 0, 0}));
}

TEST(JsonReader, TakesAnIntegerHoweverItIsWritten) {
    std::int32_t a = 0, b = 0;
    std::uint64_t c = 0, d = 7;
    EXPECT_EQ(error_of("{\"a\": 1e3, \"b\": -2147483648.0, \"c\": 18446744073709549568.0}",
                       [&](const JsonObject& root) {
                           root.get("a", a);
                           root.get("b", b);
                           root.get("c", c);
                       }),
              "no error");
    EXPECT_EQ(a, 1000);
    EXPECT_EQ(b, std::numeric_limits<std::int32_t>::min());
    EXPECT_EQ(c, 18'446'744'073'709'549'568u);
    // One more than the type has.
    EXPECT_EQ(error_of("{\"a\": 2147483648.0, \"d\": 18446744073709551616}",
                       [&](const JsonObject& root) {
                           root.get("a", a);
                           root.get("d", d);
                       }),
              "t.json:1:7: error: /a: must be from -2147483648 to 2147483647, found 2147483648.0\n"
              "t.json:1:26: error: /d: must be from 0 to 18446744073709551615, found 1.8446744073709552e+19");
    EXPECT_EQ(d, 7u);
}

// A megabyte of mistakes: each has to be looked up in it.
TEST(JsonReader, TellsTheFirstMistakesAlone) {
    std::string text = "{\"a\": 1";
    for (int i = 0; i < 60'000; ++i) text += ", \"x" + std::to_string(i) + "\": 1";
    const std::string errors = error_of(text + "}", [](const JsonObject& root) { root.has("a"); });
    EXPECT_EQ(static_cast<std::size_t>(std::count(errors.begin(), errors.end(), '\n')),
              JsonDocument::max_errors);
    EXPECT_TRUE(errors.ends_with("t.json: error: there may be more; these are the first found")) << errors;
}

TEST(JsonReader, KeysThatAreDataAreAllKnown) {
    std::string text = "{\"map\": {\"k\": {}";
    for (int i = 0; i < 60'000; ++i) text += ", \"k" + std::to_string(i) + "\": {}";
    std::size_t count = 0;
    EXPECT_EQ(
        error_of(text + "}}", [&](const JsonObject& root) { count = root.object("map").members().size(); }),
        "no error");
    EXPECT_EQ(count, 60'001u);
}

TEST(JsonReader, ReportsTheAllowedRange) {
    int a = 1, b = 1, c = 1;
    double d = 1;
    float e = 1;
    std::uint32_t f = 1;
    std::uint64_t g = 1;
    const std::string error =
        error_of("{\"a\": 0, \"b\": 5000000000,\n\"c\": -1, \"d\": 0,\n\"e\": 1e40, \"f\": -1,\n\"g\": -1}",
                 [&](const JsonObject& root) {
                     root.get("a", a, range(1, 16384));
                     root.get("b", b);
                     root.get("c", c, at_least(0));
                     root.get("d", d, above(0));
                     root.get("e", e);
                     root.get("f", f);
                     root.get("g", g);
                 });
    EXPECT_EQ(error,
              "t.json:1:7: error: /a: must be from 1 to 16384, found 0\n"
              "t.json:1:15: error: /b: must be from -2147483648 to 2147483647, found 5000000000\n"
              "t.json:2:6: error: /c: must be at least 0, found -1\n"
              "t.json:2:15: error: /d: must be greater than 0, found 0\n"
              "t.json:3:6: error: /e: too large for single precision, found 1e+40\n"
              "t.json:3:17: error: /f: must be from 0 to 4294967295, found -1\n"
              "t.json:4:6: error: /g: must be from 0 to 18446744073709551615, found -1");
}

TEST(JsonReader, ReportsUnknownAndMissingKeysAndNames) {
    std::string mode, name;
    const std::string error = error_of(
        "{\"mode\": \"fsat\",\n  \"wdith\": 1, \"camera\": {\n    \"eey\": 3},\n \"other\": {\"nested\": "
        "1},\n \"q\": 1}",
        [&](const JsonObject& root) {
            int width = 0;
            Vec3 eye{};
            root.get("mode", mode, {"fast", "exact"});
            root.get("width", width);
            root.require("name", name);
            root.object("camera").require("eye", eye);
        });
    EXPECT_EQ(
        error,
        "t.json:1:1: error: \"name\" is missing; add it\n"
        "t.json:1:10: error: /mode: unknown name \"fsat\"; did you mean \"fast\"? choices: \"fast\", "
        "\"exact\"\n"
        "t.json:2:3: error: /wdith: unknown key; did you mean \"width\"?\n"
        "t.json:2:25: error: /camera: \"eye\" is missing; add it\n"
        "t.json:3:5: error: /camera/eey: unknown key; did you mean \"eye\"?\n"
        "t.json:4:2: error: /other: unknown key; known here: \"mode\", \"width\", \"name\", \"camera\"\n"
        "t.json:5:2: error: /q: unknown key; known here: \"mode\", \"width\", \"name\", \"camera\"");
    EXPECT_EQ(mode, "");
}

TEST(JsonReader, ListOrOneTakesBoth) {
    std::size_t one = 0, two = 0, none = 1;
    EXPECT_EQ(error_of("{\"one\": 3, \"two\": [1, 2]}",
                       [&](const JsonObject& root) {
                           one = root.value("one").list_or_one().size();
                           two = root.value("two").list_or_one().size();
                           none = root.value("none").list_or_one().size();
                       }),
              "no error");
    EXPECT_EQ(one, 1u);
    EXPECT_EQ(two, 2u);
    EXPECT_EQ(none, 0u);
}

TEST(JsonReader, RefusesARootThatIsNoObject) {
    EXPECT_EQ(error_of("\n [1]", [](const JsonObject&) {}),
              "t.json:2:2: error: expected an object, found a list of 1");
}

TEST(JsonReader, ErrorsOfTheCallerHaveAPlaceToo) {
    EXPECT_EQ(
        error_of("{\"a\":\n {\"b\": 1}}",
                 [](const JsonObject& root) {
                     root.object("a").error("first");
                     root.object("a").error("b", "second");
                     root.error("absent", "third");
                 }),
        "t.json:1:1: error: /absent: third\nt.json:2:2: error: /a: first\nt.json:2:8: error: /a/b: second");
}

TEST(JsonReader, NamesTheOptionThatSetAWrongValue) {
    JsonDocument document = JsonDocument::parse("{\"a\": 1}", "t.json");
    document.set("/a=x");
    JsonReader reader(std::move(document));
    int a = 0;
    reader.root().get("a", a);
    try {
        reader.finish();
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "--set /a=x: error: /a: expected an integer, found \"x\"");
    }
}

}  // namespace
}  // namespace ctpbench
