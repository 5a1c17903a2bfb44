// Fuzzes what `ctpbench merge` reads of a folder: a line of finished.jsonl and two meta.json. An input is up
// to three lines: results, and one meta.json each.
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "kernels/platform.h"
#include "report/meta_comparison.h"
#include "report/results_json.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ctpbench;
    std::string_view rest(reinterpret_cast<const char*>(data), size);
    const auto next = [&] {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(line.size() + 1, rest.size()));
        return nlohmann::json::parse(line, nullptr, false);
    };
    try {
        // As text: NaN is null there, and equals itself.
        const auto dumped = [](const Results& results) {
            return results_to_json(results).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
        };
        const std::string written = dumped(results_from_json(next()));
        if (dumped(results_from_json(nlohmann::json::parse(written))) != written) trap();
    } catch (const nlohmann::json::exception&) {
        // read_finished() names the file and the line
    }
    const nlohmann::json there = next(), here = next();
    if (there.is_object() && here.is_object()) {
        differences(there, here);
        differences_of_machine(there, here);
    }
    return 0;
}
