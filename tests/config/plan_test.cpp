#include "config/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/error.h"

namespace ctpbench::test {
namespace {

Cell cell(const char* scene, std::uint32_t spheres, const char* strategy) {
    Contender contender;
    contender.backend = "cpu", contender.strategy = strategy, contender.methods = "watertight";
    contender.traversal = "single";
    return {{scene, spheres, 0.03, "quality"}, contender};
}

std::vector<Cell> cells() {
    std::vector<Cell> all;
    for (const std::uint32_t spheres : {1u, 2u, 3u, 4u, 5u})
        for (const char* strategy : {"ctp", "oop"}) all.push_back(cell("a", spheres, strategy));
    return all;
}

TEST(Plan, SharesAreDisjointAndAllAndKeepContestsWhole) {
    for (std::uint32_t n = 1; n <= 7; ++n) {
        std::vector<Cell> all;
        for (std::uint32_t i = 1; i <= n; ++i) {
            const std::vector<Cell> ours = cells_of({i, n}, cells());
            for (const WorkloadCells& w : group_by_workload(ours)) EXPECT_EQ(w.contenders.size(), 2u);
            // No share has two workloads more than another.
            EXPECT_GE(ours.size(), 2 * (5 / n));
            EXPECT_LE(ours.size(), 2 * ((5 + n - 1) / n));
            all.insert(all.end(), ours.begin(), ours.end());
        }
        EXPECT_EQ(all.size(), cells().size());
        for (const Cell& c : cells()) EXPECT_EQ(std::count(all.begin(), all.end(), c), 1);
    }
}

TEST(Plan, HashesTellApartWhatRowsDependOn) {
    std::set<std::string> hashes;
    const auto first = [](const Config& config, const std::vector<Cell>& c, const char* isa, int threads) {
        return plan(config, c, isa, threads).front().hash;
    };
    const Config config;
    const std::string hash = first(config, cells(), "avx2", 2);
    Config other = config;
    other.rounds = 3;
    EXPECT_NE(first(other, cells(), "avx2", 2), hash);
    other = config, other.seed = 3;
    EXPECT_NE(first(other, cells(), "avx2", 2), hash);
    EXPECT_NE(first(config, {cell("a", 1, "ctp")}, "avx2", 2), hash);
    EXPECT_NE(first(config, {cell("b", 1, "ctp"), cell("b", 1, "oop")}, "avx2", 2), hash);
    EXPECT_NE(first(config, cells(), "scalar", 2), hash);
    EXPECT_NE(first(config, cells(), "avx2", 3), hash);
    // Other workloads and a description are no matter to this one.
    other = config, other.description = "x", other.matrix.scene = {"z"};
    EXPECT_EQ(first(other, {cell("a", 1, "ctp"), cell("a", 1, "oop")}, "avx2", 2), hash);
    for (const PlannedWorkload& w : plan(config, cells(), "avx2", 2)) hashes.insert(w.hash);
    EXPECT_EQ(hashes.size(), 5u);
}

TEST(Plan, ReadsShares) {
    EXPECT_EQ(parse_shard("2/8"), (Shard{2, 8}));
    EXPECT_EQ(parse_shard("1/1"), Shard{});
    for (const char* wrong : {"", "1", "0/3", "4/3", "1/0", "a/b", "1/3x", "-1/3", "1/ 3", "1/3/5"})
        EXPECT_THROW(parse_shard(wrong), Error) << wrong;
}

}  // namespace
}  // namespace ctpbench::test
