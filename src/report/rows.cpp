#include "report/rows.h"

#include "base/hash.h"

namespace ctpbench {
RowsFile::RowsFile(const std::filesystem::path& folder, std::string run_id, std::string experiment,
                   int threads, std::uint64_t keep)
    : file_(folder / "rows.csv",
            {"run_id",
             "experiment",
             "scene",
             "scene_source",
             "triangles",
             "spheres",
             "sphere_radius",
             "builder",
             "backend",
             "threads",
             "strategy",
             "restart_carries_t",
             "traversal",
             "methods",
             "types",
             "triangle_test",
             "sphere_test",
             "box_test",
             "offset",
             "bounce_limit",
             "roulette",
             "shade",
             "launch",
             "kernel",
             "start_ms",
             "bounce",
             "round",
             "active_rays",
             "rays",
             "time_ms",
             "throughput_mrays_s",
             "hit_hash",
             "image_hash",
             "dropped_samples",
             "clamped_samples",
             "valid",
             "mismatch_rate"},
            keep),
      run_id_(std::move(run_id)),
      experiment_(std::move(experiment)),
      threads_(threads) {}

int RowsFile::threads_of(const Contender& contender) const {
    return contender.threads == 0 ? threads_ : static_cast<int>(contender.threads);
}

void RowsFile::append(const Results& results, const std::vector<Row>& rows) {
    std::vector<std::vector<std::string>> lines;
    for (const Row& row : rows) {
        const CellResult& cell = results.cells[row.cell];
        const bool timed = row.seconds > 0.0;
        lines.push_back({run_id_,
                         experiment_,
                         cell.workload.scene,
                         cell.scene_source,
                         std::to_string(cell.triangles),
                         std::to_string(cell.workload.spheres),
                         csv_number(cell.workload.sphere_radius),
                         cell.workload.builder,
                         cell.contender.backend,
                         std::to_string(threads_of(cell.contender)),
                         cell.contender.strategy,
                         cell.contender.restart_carries_t ? "true" : "false",
                         cell.contender.traversal,
                         cell.contender.methods,
                         cell.contender.types,
                         cell.contender.triangle_test,
                         cell.contender.sphere_test,
                         cell.contender.box_test,
                         cell.contender.offset,
                         std::to_string(cell.contender.bounce_limit),
                         cell.contender.roulette ? "true" : "false",
                         cell.contender.shade,
                         cell.contender.launch,
                         row.kernel,
                         row.start_seconds >= 0.0 ? csv_number(row.start_seconds * 1e3) : "",
                         std::to_string(row.bounce),
                         std::to_string(row.round),
                         std::to_string(row.active_rays),
                         std::to_string(row.rays),
                         timed ? csv_number(row.seconds * 1e3) : "",
                         timed ? csv_number(row.mrays_per_second()) : "",
                         row.hit_hash != 0 ? hex(row.hit_hash) : "",
                         row.image_hash != 0 ? hex(row.image_hash) : "",
                         row.kernel == "shade" ? std::to_string(row.dropped) : "",
                         row.kernel == "blend" ? std::to_string(row.clamped) : "",
                         cell.validity(),
                         cell.checked ? csv_number(cell.verdict.mismatch_rate()) : ""});
    }
    file_.append(lines);
}

}  // namespace ctpbench
