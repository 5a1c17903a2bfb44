// finished.jsonl: a line per workload that a run has finished, with all that was measured of it. The line is
// the end mark of the workload's rows and is written after them, so that rows behind the last mark are those
// of a workload that was cut short.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "measure/results.h"
#include "report/output_file.h"

namespace ctpbench {

struct FinishedWorkload {
    std::string hash;                            // that the plan gives it
    std::uint64_t rows_begin = 0, rows_end = 0;  // bytes of rows.csv
    std::uint64_t rows_hash = 0;                 // of these bytes
    Results results;                             // of this workload alone
};

struct FinishedLog {
    std::vector<FinishedWorkload> workloads;
    std::uint64_t bytes = 0;       // of finished.jsonl that are whole lines
    std::uint64_t rows_bytes = 0;  // of rows.csv up to the last mark; 0: there is none
    std::uint64_t rows_cut = 0;    // and behind it
};

// Of the folder of a run; a torn last line does not count. Throws Error(usage), naming the file, if a line is
// damaged or rows.csv has not the rows that are marked.
FinishedLog read_finished(const std::filesystem::path& folder);

class FinishedFile {
public:
    FinishedFile(const std::filesystem::path& folder, std::uint64_t keep);
    // Makes the rows safe first. They are those from `rows_begin` on.
    void append(const std::string& hash, GrowingFile& rows, std::uint64_t rows_begin,
                const Results& of_workload);

private:
    GrowingFile file_;
};

// How many there are of each, and what came after that.
struct ResultsMark {
    explicit ResultsMark(const Results& results);
    Results since(const Results& results) const;

private:
    std::size_t cells_, profiles_, trees_, scenes_, stability_, notices_;
};
void append(Results& into, const Results& more);

// The bytes of a file from `begin` to before `end`. Throws Error(usage) if it has not that many.
std::string read_part(const std::filesystem::path& path, std::uint64_t begin, std::uint64_t end);

}  // namespace ctpbench
