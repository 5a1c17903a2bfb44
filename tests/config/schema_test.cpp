#include "config/schema.h"

#include <algorithm>
#include <set>

#include "base/error.h"
#include "config/axes.h"
#include "config/schema_cases.h"
#include "experiment.h"
#include "names.h"
#include "program/run_program.h"

namespace ctpbench::test {
namespace {

using nlohmann::json;

// What the schema leaves to the reader: parts of the messages of rules that tie keys together.
constexpr const char* kTies[] = {"means nothing",
                                 "is not among the strategies measured",
                                 "makes more than",
                                 "is there already",
                                 "leaves nothing",
                                 "belongs to studies of speed",
                                 "needs rendered frames",
                                 "needs recorded rays",
                                 "compares types",
                                 "compares with",
                                 "profiles rays",
                                 "concerns the CPU alone",
                                 "frames are rendered by",
                                 "every contender must render",
                                 "needs measurements",
                                 "may never be reached",
                                 "is shorter than min_time",
                                 "a study of methods or of pictures measures"};

class Schema : public ProgramTest {
protected:
    void SetUp() override {
        ProgramTest::SetUp();
        if (std::system("/usr/bin/python3 -c 'import jsonschema' 2>/dev/null") != 0)
            GTEST_SKIP() << "needs a validator for /usr/bin/python3: apt-get install python3-jsonschema";
    }

    // Of each document, whether the schema accepts it.
    std::vector<bool> accepted(const std::filesystem::path& schema,
                               const std::vector<json>& documents) const {
        std::string lines;
        for (const json& d : documents) lines += d.dump() + "\n";
        write("documents", lines);
        const Outcome outcome = run_shell("'" CTPBENCH_SOURCE_DIR "/tests/config/validate.py' '" +
                                          schema.string() + "' '" + (folder_ / "documents").string() + "'");
        EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
        std::vector<bool> verdicts;
        for (const char c : outcome.output)
            if (c != '\n') verdicts.push_back(c == '1');
        EXPECT_EQ(verdicts.size(), documents.size()) << outcome.output;
        verdicts.resize(documents.size());
        return verdicts;
    }
};

struct Mistakes {
    bool any = false;
    std::string of_one_key;  // those that the schema must see too
};
Mistakes mistakes_in(const json& document) {
    Mistakes found;
    try {
        config_of(document.dump());
    } catch (const Error& error) {
        found.any = true;
        std::istringstream lines(error.what());
        for (std::string line; std::getline(lines, line);) {
            const bool tie = std::any_of(std::begin(kTies), std::end(kTies), [&](const char* part) {
                return line.find(part) != std::string::npos;
            });
            if (!tie) found.of_one_key += line + "\n";
        }
    }
    return found;
}

TEST_F(Schema, AcceptsWhatTheReaderAccepts) {
    const auto schema = config_schema(test_names());
    const std::filesystem::path file = write("schema.json", schema.dump());
    std::vector<json> bases;
    for (const char* text : {R"({"bounces": 100, "matrix": {"strategy": ["ctp", "oop"]}})",
                             R"({"bounces": 100, "study": "stability", "matrix": {}})",
                             R"({"bounces": 100, "study": "convergence", "matrix": {"shade": "ctp"}})",
                             R"({"bounces": 100, "measure": false, "matrix": {}})"}) {
        json& base = bases.emplace_back(json::parse(text));
        base["schema_version"] = 1, base["experiment"] = "e";
        ASSERT_FALSE(mistakes_in(base).any);
    }
    std::vector<json> cases = bases;
    ConfigMutator mutator(schema, 7);
    for (int i = 0; i < 4000; ++i)
        cases.push_back(mutator.mutated(bases[static_cast<std::size_t>(i) % bases.size()]));
    const std::vector<bool> by_schema = accepted(file, cases);
    std::size_t good = 0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Mistakes mistakes = mistakes_in(cases[i]);
        good += by_schema[i];
        // The value of a key that means nothing is not looked at, so the schema may see more than the reader.
        EXPECT_FALSE(by_schema[i] && !mistakes.of_one_key.empty())
            << "accepted by the schema alone: " << cases[i].dump().substr(0, 300) << "\n"
            << mistakes.of_one_key;
        EXPECT_TRUE(by_schema[i] || mistakes.any)
            << "accepted by the reader alone: " << cases[i].dump().substr(0, 300);
    }
    // Both kinds are there in numbers.
    EXPECT_GT(good, cases.size() / 10);
    EXPECT_LT(good, cases.size() * 9 / 10);
}

TEST_F(Schema, DescribesEveryKey) {
    const auto schema = config_schema(test_names());
    Axes axes;
    for_each_axis(axes, [&](const char* axis, const auto&) {
        const auto& property = schema.at("definitions").at("axes").at("properties").at(axis);
        EXPECT_NE(property.at("description"), "") << axis;
    });
    for (const auto& [key, property] : schema.at("properties").items())
        EXPECT_NE(property.at("description"), "") << key;
}

TEST_F(Schema, OfTheFileIsTheProgramsAndEveryConfigPassesIt) {
    const std::filesystem::path folder = CTPBENCH_SOURCE_DIR "/configs";
    const Outcome printed = run("--schema");
    EXPECT_EQ(printed.exit_code, 0);
    KnownNames names = known_names();
    names.obstacle = nullptr;  // what this build lacks is no matter here
    std::set<std::filesystem::path> named;
    std::vector<json> documents;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".json") continue;
        json& config = documents.emplace_back(JsonDocument::load(entry.path()).value());
        named.insert(folder / config.value("$schema", "none"));
        // What is echoed has every key that means something to it.
        json echo = to_json(load_config(entry.path(), {}, names));
        documents.push_back(echo);
    }
    ASSERT_GT(documents.size(), 20u);
    ASSERT_EQ(named.size(), 1u);
    EXPECT_EQ(read(*named.begin()), printed.output)
        << "write it anew: ctpbench --schema > " << *named.begin();
    const std::vector<bool> verdicts = accepted(*named.begin(), documents);
    for (std::size_t i = 0; i < documents.size(); ++i) EXPECT_TRUE(verdicts[i]) << documents[i].dump();
}

}  // namespace
}  // namespace ctpbench::test
