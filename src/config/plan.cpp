#include "config/plan.h"

#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/error.h"
#include "base/hash.h"

namespace ctpbench {
namespace {

constexpr std::uint32_t kMaxShards = 100'000;

std::optional<std::uint32_t> whole_number(std::string_view text) {
    std::uint32_t value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

}  // namespace

std::vector<PlannedWorkload> plan(const Config& config, const std::vector<Cell>& cells,
                                  const std::string& isa, int threads) {
    nlohmann::json settings = to_json(config);
    // Which cells there are is no matter to those that are.
    for (const char* key : {"experiment", "description", "matrix", "exclude", "include"}) settings.erase(key);
    std::vector<PlannedWorkload> planned;
    for (WorkloadCells& group : group_by_workload(cells)) {
        nlohmann::json names = nlohmann::json::array();
        for (const Contender& c : group.contenders) names.push_back(Cell{group.workload, c}.name());
        const std::string text = nlohmann::json{
            {"settings", settings},
            {"workload", group.workload.name()},
            {"contenders", names},
            {"isa", isa},
            {"threads", threads}}.dump();
        planned.push_back({std::move(group), hex(hash_bytes(text.data(), text.size()))});
    }
    return planned;
}

Shard parse_shard(const std::string& text) {
    const std::size_t slash = text.find('/');
    if (slash != std::string::npos) {
        const auto index = whole_number(std::string_view(text).substr(0, slash));
        const auto count = whole_number(std::string_view(text).substr(slash + 1));
        if (index && count && *count >= 1 && *count <= kMaxShards && *index >= 1 && *index <= *count)
            return {*index, *count};
    }
    throw Error(ExitCode::usage, "ctpbench: error: --shard " + text +
                                     ": must be a share and how many there are, as in 1/4 to 4/4");
}

std::vector<Cell> cells_of(const Shard& shard, const std::vector<Cell>& cells) {
    const std::vector<WorkloadCells> groups = group_by_workload(cells);
    std::vector<Cell> ours;
    for (const Cell& cell : cells)
        for (std::size_t i = 0; i < groups.size(); ++i)
            if (shard.has(i) && groups[i].workload == cell.workload) ours.push_back(cell);
    return ours;
}

}  // namespace ctpbench
