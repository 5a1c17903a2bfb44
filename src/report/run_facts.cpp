#include "report/run_facts.h"

#include <algorithm>
#include <set>
#include <sstream>

namespace ctpbench {
namespace {

enum class Bears { on_machine, on_yardstick, on_build };
struct Fact {
    const char* name;
    const char* pointer;  // into meta.json
    Bears bears;
};
constexpr Fact facts[] = {
    {"cpu", "/machine/cpu", Bears::on_machine},
    {"cpu family, model and stepping", "/machine/cpu_model", Bears::on_machine},
    {"features of the cpu", "/machine/isa_flags", Bears::on_machine},
    {"cores", "/machine/cores", Bears::on_machine},
    {"gpu", "/gpu/name", Bears::on_machine},
    {"gpu driver", "/gpu/driver", Bears::on_build},
    {"instruction set of traversal interleaved", "/isa", Bears::on_build},
    {"Embree", "/build/embree", Bears::on_yardstick},
    {"compiler", "/build/compiler", Bears::on_build},
    {"flags", "/build/flags", Bears::on_build},
    {"build type", "/build/build_type", Bears::on_build},
};

// What its runs say, each once.
std::set<std::string> values(const RecordedResults& results, const Fact& fact) {
    std::set<std::string> all;
    const nlohmann::json::json_pointer pointer(fact.pointer);
    for (const nlohmann::json& meta : results.meta) {
        if (!meta.contains(pointer) || meta.at(pointer).is_null()) continue;
        const nlohmann::json& value = meta.at(pointer);
        all.insert(value.is_string() ? value.get<std::string>() : value.dump());
    }
    return all;
}

std::string joined(const std::set<std::string>& all) {
    std::string text;
    for (const std::string& one : all) text += (text.empty() ? "" : "; ") + one;
    return text.empty() ? "not recorded" : text;
}

// Of long lists of words, those that only one side has.
std::string only_in(const std::set<std::string>& a, const std::set<std::string>& b) {
    std::set<std::string> other, mine;
    for (const std::string& text : b)
        for (std::istringstream in(text); in;) {
            std::string word;
            if (in >> word) other.insert(word);
        }
    for (const std::string& text : a)
        for (std::istringstream in(text); in;) {
            std::string word;
            if (in >> word && !other.contains(word)) mine.insert(word);
        }
    std::string words;
    for (const std::string& word : mine) words += (words.empty() ? "" : " ") + word;
    return words.empty() ? "-" : words;
}

}  // namespace

FactDifferences compare_facts(const RecordedResults& base, const RecordedResults& fresh) {
    FactDifferences differences;
    const auto unknown = [](const RecordedResults& r) {
        return std::any_of(r.meta.begin(), r.meta.end(), [](const nlohmann::json& m) { return m.is_null(); });
    };
    for (const RecordedResults* r : {&base, &fresh})
        if (unknown(*r)) {
            differences.lines.push_back(r->folder.string() + ": no meta.json, so the machine is not known");
            differences.machine = true;
        }
    for (const Fact& fact : facts) {
        const std::set<std::string> a = values(base, fact), b = values(fresh, fact);
        if (a == b) continue;
        const bool listed = std::string_view(fact.pointer) == "/machine/isa_flags";
        differences.lines.push_back(std::string(fact.name) + ": " + (listed ? only_in(a, b) : joined(a)) +
                                    " | " + (listed ? only_in(b, a) : joined(b)));
        if (fact.bears == Bears::on_machine) differences.machine = true;
        if (fact.bears == Bears::on_yardstick) differences.yardstick = true;
    }
    return differences;
}

}  // namespace ctpbench
