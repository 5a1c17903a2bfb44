// What rows of two runs of the same cells have in common.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace ctpbench::test {

using RowKey = std::map<std::string, std::string>;

// Each row without its times and the id of its run. The rows as read_csv() gives them.
inline std::multiset<RowKey> keys_of(std::vector<RowKey> rows) {
    std::multiset<RowKey> keys;
    for (RowKey& row : rows) {
        for (const char* varies : {"run_id", "start_ms", "time_ms", "throughput_mrays_s"}) row.erase(varies);
        keys.insert(std::move(row));
    }
    return keys;
}

}  // namespace ctpbench::test
