// Folders of results as runs write them, with speeds and noise of a test's choosing.
#pragma once

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "noise.h"
#include "report/csv.h"
#include "report/rows.h"

namespace ctpbench::test {

struct NoisyContender {
    std::string strategy;
    double speed = 1.0;  // as multiples of the yardstick's
    bool valid = true;
    std::string shade = no_shade;
};

struct NoisyRun {
    std::vector<NoisyContender> contenders = {{"ctp", 0.8}, {"oop", 0.7}, {"embree_robust", 1.0}};
    std::uint32_t rounds = 31;
    std::uint32_t batch = 1000;
    double noise = 0.02;      // of a timing
    double machine = 1.0;     // speed of the whole machine
    double slow_phase = 1.0;  // of it in the second half of the rounds
    std::string cpu = "a processor";
    int threads = 1;

    // Writes it; the folder must not be there yet.
    void write(const std::filesystem::path& folder, std::uint64_t seed) const {
        std::filesystem::create_directories(folder);
        if (!cpu.empty()) write_file(folder / "meta.json", "{\"machine\": {\"cpu\": \"" + cpu + "\"}}\n");
        Results results;
        for (const NoisyContender& c : contenders) {
            CellResult& cell = results.cells.emplace_back();
            cell.workload = {"smoke", 0, 0.03, "quality"};
            const bool yardstick = c.strategy.starts_with("embree");
            cell.contender = {"cpu", c.strategy, true, yardstick ? own_way : "single",
                              yardstick ? own_way : "watertight"};
            cell.contender.shade = c.shade;
            if (yardstick) cell.contender.types = own_way;
            cell.scene_source = "stand-in", cell.checked = true, cell.valid = c.valid;
        }
        RowsFile file(folder, "run-" + std::to_string(seed), "noisy", threads);
        Noise noise_of(seed);
        for (std::uint32_t round = 0; round < rounds; ++round) {
            std::vector<Row> rows;
            const double phase = machine * (2 * round < rounds ? 1.0 : slow_phase);
            for (std::size_t c = 0; c < contenders.size(); ++c)
                for (std::uint32_t bounce = 0; bounce < 2; ++bounce) {
                    Row row;
                    row.cell = c, row.kernel = contenders[c].shade == no_shade ? "intersect" : "shade";
                    row.bounce = bounce, row.round = round;
                    row.active_rays = 10 * batch / (bounce + 1), row.rays = batch;
                    row.hit_hash = 1 + bounce;
                    row.seconds = batch * 1e-6 / (contenders[c].speed * phase) * noise_of.factor(noise);
                    rows.push_back(row);
                }
            file.append(results, rows);
        }
    }
};

}  // namespace ctpbench::test
