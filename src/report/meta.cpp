#include "report/meta.h"

#include <nlohmann/json.hpp>

#include "base/hash.h"
#include "base/type_names.h"
#include "kernels/materials/list.h"
#include "kernels/primitives/list.h"
#include "measure/machine.h"
#include "report/output_file.h"

namespace ctpbench {
namespace {

nlohmann::json scene_json(const SceneResult& s) {
    nlohmann::json bytes = nlohmann::json::object();
    for (const SceneColumn& column : s.columns) bytes[column.name] = column.bytes;
    return {{"name", s.name},
            {"spheres", s.spheres},
            {"source", s.source},
            {"triangles", s.triangles},
            {"dropped_triangles", s.dropped_triangles},
            {"hash", hex(s.hash)},
            {"base_hash", hex(s.base_hash)},
            {"sphere_hit_share", s.sphere_hit_share},
            {"needs",
             {{"primitives", names_of<Primitives<Watertight>>(s.needs.primitives)},
              {"materials", names_of<Materials>(s.needs.materials)},
              {"textured", s.needs.textured}}},
            {"dropped",
             {{"unused_vertices", s.savings.unused_vertices},
              {"unused_texcoords", s.savings.unused_texcoords},
              {"unused_materials", s.savings.unused_materials},
              {"merged_materials", s.savings.merged_materials}}},
            {"bytes", bytes}};
}

}  // namespace

nlohmann::json meta_of(const Config& config, const RunRecord& run, const Results& results,
                       const std::string& state) {
    const nlohmann::json effective = to_json(config);
    const std::string text = effective.dump();
    nlohmann::json scenes = nlohmann::json::array(), trees = nlohmann::json::array();
    for (const SceneResult& s : results.scenes) scenes.push_back(scene_json(s));
    for (const TreeResult& t : results.trees)
        if (t.nodes > 0)
            trees.push_back({{"workload", t.workload.name()}, {"kind", t.kind}, {"hash", hex(t.hash)}});
    nlohmann::json verdicts = nlohmann::json::object();
    for (const CellResult& c : results.cells)
        if (c.checked && c.verdict.rays > 0)
            verdicts[c.workload.name() + "/" + c.contender.label()] = c.verdict.text();
    nlohmann::json exams = nlohmann::json::object();
    for (const CellResult& c : results.cells)
        if (c.accuracy) exams[c.workload.name() + "/" + c.contender.label()] = c.accuracy->verdict.text();
    nlohmann::json gpu;
    if (const auto& device = run.device)
        gpu = {{"device", device->number},
               {"name", device->name},
               {"multiprocessors", device->multiprocessors},
               {"architecture", device->architecture},
               {"memory_bytes", device->memory_bytes},
               {"l2_bytes", device->l2_bytes},
               {"highest_clock_khz", device->clock_khz},
               {"highest_memory_clock_khz", device->memory_clock_khz},
               {"ecc", device->ecc},
               {"driver", device->driver},
               {"runtime", device->runtime}};
    nlohmann::json workloads = nlohmann::json::array(), resumed = nlohmann::json::array();
    for (const PlannedWorkload& w : run.workloads)
        workloads.push_back(
            {{"name", w.cells.workload.name()}, {"contenders", w.cells.contenders.size()}, {"hash", w.hash}});
    for (const Resumption& r : run.resumed)
        resumed.push_back({{"command", r.command}, {"workloads_kept", r.workloads_kept}});
    return {
        {"schema_version", kMetaSchemaVersion},
        {"run_id", run.run_id},
        {"state", state},
        {"command", run.command},
        {"resumed", resumed},
        {"shard", run.shard.text()},
        {"workloads", workloads},
        {"threads", run.threads},
        {"isa", run.isa},
        {"config", effective},
        {"config_hash", hex(hash_bytes(text.data(), text.size()))},
        {"machine", describe_machine()},
        {"gpu", gpu},
        {"build", describe_build()},
        {"scenes", scenes},
        {"trees", trees},
        {"oracle", verdicts},
        {"exams", exams},
        {"notices", results.notices},
        {"peak_memory_bytes", peak_memory_bytes()},
    };
}

void write_meta(const std::filesystem::path& folder, const nlohmann::json& meta) {
    write_file(folder / "meta.json",
               meta.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

}  // namespace ctpbench
