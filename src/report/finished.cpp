#include "report/finished.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/hash.h"
#include "report/results_json.h"

namespace ctpbench {
namespace {

namespace fs = std::filesystem;
constexpr const char* kName = "finished.jsonl";

FinishedWorkload parse(const std::string& line) {
    const nlohmann::json json = nlohmann::json::parse(line);
    FinishedWorkload w;
    json.at("hash").get_to(w.hash);
    json.at("rows_begin").get_to(w.rows_begin);
    json.at("rows_end").get_to(w.rows_end);
    json.at("rows_hash").get_to(w.rows_hash);
    w.results = results_from_json(json.at("results"));
    return w;
}

std::uint64_t hash_of_part(const fs::path& path, std::uint64_t begin, std::uint64_t end) {
    const std::string part = read_part(path, begin, end);
    return hash_bytes(part.data(), part.size());
}

template <class T>
std::vector<T> tail(const std::vector<T>& list, std::size_t from) {
    return {list.begin() + static_cast<std::ptrdiff_t>(from), list.end()};
}

template <class T>
void add(std::vector<T>& into, const std::vector<T>& more) {
    into.insert(into.end(), more.begin(), more.end());
}

}  // namespace

FinishedLog read_finished(const fs::path& folder) {
    FinishedLog log;
    std::ifstream file(folder / kName, std::ios::binary);
    std::size_t number = 0;
    for (std::string line; std::getline(file, line) && !file.eof();) {
        ++number;
        try {
            log.workloads.push_back(parse(line));
        } catch (const nlohmann::json::exception& problem) {
            if (file.peek() == std::ifstream::traits_type::eof()) break;  // torn, as when the power was lost
            throw Error(ExitCode::usage, (folder / kName).string() + ":" + std::to_string(number) +
                                             ": error: is damaged: " + problem.what() +
                                             "; take out this line and all below it, and --resume goes on "
                                             "from there");
        }
        log.bytes += line.size() + 1;
        const FinishedWorkload& w = log.workloads.back();
        if (hash_of_part(folder / "rows.csv", w.rows_begin, w.rows_end) != w.rows_hash)
            throw Error(ExitCode::usage, (folder / "rows.csv").string() + ": error: its bytes " +
                                             std::to_string(w.rows_begin) + " to " +
                                             std::to_string(w.rows_end) +
                                             " are not those that the run wrote, as " + kName +
                                             " has it; name another folder with --out");
        log.rows_bytes = w.rows_end;
    }
    std::error_code missing;
    const std::uintmax_t size = fs::file_size(folder / "rows.csv", missing);
    if (!missing) log.rows_cut = size - log.rows_bytes;
    return log;
}

FinishedFile::FinishedFile(const fs::path& folder, std::uint64_t keep) : file_(folder / kName, keep) {}

void FinishedFile::append(const std::string& hash, GrowingFile& rows, std::uint64_t rows_begin,
                          const Results& of_workload) {
    rows.sync();
    const nlohmann::json json = {{"hash", hash},
                                 {"rows_begin", rows_begin},
                                 {"rows_end", rows.size()},
                                 {"rows_hash", hash_of_part(rows.path(), rows_begin, rows.size())},
                                 {"results", results_to_json(of_workload)}};
    file_.append(json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
    file_.sync();
}

ResultsMark::ResultsMark(const Results& r)
    : cells_(r.cells.size()),
      profiles_(r.profiles.size()),
      trees_(r.trees.size()),
      scenes_(r.scenes.size()),
      stability_(r.stability.size()),
      notices_(r.notices.size()) {}

Results ResultsMark::since(const Results& r) const {
    return {tail(r.cells, cells_),   tail(r.profiles, profiles_),   tail(r.trees, trees_),
            tail(r.scenes, scenes_), tail(r.stability, stability_), tail(r.notices, notices_)};
}

void append(Results& into, const Results& more) {
    add(into.cells, more.cells), add(into.profiles, more.profiles), add(into.trees, more.trees);
    add(into.scenes, more.scenes), add(into.stability, more.stability);
    for (const std::string& notice : more.notices)
        if (std::find(into.notices.begin(), into.notices.end(), notice) == into.notices.end())
            into.notices.push_back(notice);
}

std::string read_part(const fs::path& path, std::uint64_t begin, std::uint64_t end) {
    std::string part(begin < end ? end - begin : 0, '\0');
    std::ifstream file(path, std::ios::binary);
    file.seekg(static_cast<std::streamoff>(begin));
    file.read(part.data(), static_cast<std::streamsize>(part.size()));
    if (!file)
        throw Error(ExitCode::usage, path.string() + ": error: is missing or has less than the " +
                                         std::to_string(end) +
                                         " bytes that the run wrote; name another folder "
                                         "with --out");
    return part;
}

}  // namespace ctpbench
