// A folder of results, read back: what each contender's kernels reached, round by round. The folder is that
// of one run, or holds several of them, whose rounds then count together.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace ctpbench {

// One kernel of one contender on one workload.
struct RecordedKernel {
    std::string key;          // all that identifies it
    std::string name;         // `conference/1000/ctp/1thread, intersect`
    std::string place;        // workload, backend and threads: where its yardstick is
    bool yardstick = false;   // a library's, or a fixed kernel: not what is under test
    bool normalises = false;  // the yardstick that others are divided by
    bool renders = false;     // a stage of whole frames, whose rounds no yardstick shares
    bool valid = true;        // no row says that it was rejected
    struct Rays {
        double active = 0.0, timed = 0.0;
        bool operator==(const Rays&) const = default;
    };
    std::map<double, Rays> rays;             // by bounce
    std::map<double, std::string> hit_hash;  // by bounce; may be empty
    // By run, Mrays/s over all bounces by number of the round.
    std::map<std::string, std::map<double, double>> runs;
    std::size_t incomplete = 0;  // rounds that lack a bounce; they are not among the above
};

struct RecordedResults {
    std::filesystem::path folder;
    std::vector<RecordedKernel> kernels;  // in the order of the file
    std::vector<nlohmann::json> meta;     // by run; null where there is none

    const RecordedKernel* find(const std::string& key) const;  // null: there is none
    // Whose ratio to the kernel's is what is compared; null: nobody's.
    const RecordedKernel* yardstick_of(const RecordedKernel& kernel) const;
};

// By run and round, the kernel's speed: as multiples of the other's in the same rounds, or if that is null in
// Mrays/s.
std::vector<std::vector<double>> speeds_of(const RecordedKernel& kernel, const RecordedKernel* yardstick);

// Throws Error(usage) if there are no results in it, or none that can be read.
RecordedResults read_results(const std::filesystem::path& folder);

}  // namespace ctpbench
