#include "report/stability.h"

#include <algorithm>
#include <cstdio>
#include <map>

#include "measure/statistics.h"

namespace ctpbench {
namespace {

double per_million(const StabilityRow& row) {
    const Verdict& v = row.accuracy.verdict;
    return v.rays == 0 ? 0.0
                       : 1e6 * static_cast<double>(row.accuracy.failures()) / static_cast<double>(v.rays);
}

// "." or at most four characters: 7, 123, 4.5k, 110k, 1M.
std::string short_count(double value) {
    char text[16];
    if (value == 0.0) return ".";
    if (value < 0.5)
        return "<1";
    else if (value < 999.5)
        std::snprintf(text, sizeof text, "%.0f", value);
    else if (value < 9950.0)
        std::snprintf(text, sizeof text, "%.1fk", value * 1e-3);
    else if (value < 999500.0)
        std::snprintf(text, sizeof text, "%.0fk", value * 1e-3);
    else
        return "1M";
    return text;
}

template <class T>
void add_once(std::vector<T>& list, const T& value) {
    if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

}  // namespace

StabilityFile::StabilityFile(const std::filesystem::path& folder)
    : file_(folder / "stability.csv",
            {"kind", "method", "is_default", "workload", "rays", "failures", "failures_per_million", "lo",
             "hi", "p99_scaled_error", "backend", "missed", "false_hits", "wrong_primitives", "t_mismatches",
             "leaks", "boundary", "not_finite"}) {}

void StabilityFile::append(const StabilityRow& row) {
    const Verdict& v = row.accuracy.verdict;
    const std::size_t failures = row.accuracy.failures();
    const Interval interval = binomial_interval(failures, v.rays);
    const auto count = [](std::size_t n) { return std::to_string(n); };
    file_.append({{row.kind, row.method, row.is_default ? "true" : "false", row.workload, count(v.rays),
                   count(failures), csv_number(per_million(row)), csv_number(1e6 * interval.lo),
                   csv_number(1e6 * interval.hi), csv_number(row.accuracy.p99_scaled_error), row.backend,
                   count(v.missed), count(v.false_hit), count(v.wrong_primitive), count(v.t_mismatch),
                   count(v.leak), count(v.boundary), count(v.not_finite)}});
}

std::string stability_text(const std::vector<StabilityRow>& rows) {
    std::vector<std::string> workloads, methods, backends;
    for (const StabilityRow& row : rows) add_once(backends, row.backend);
    const auto name = [&](const StabilityRow& row) {
        return row.kind + " " + row.method + (backends.size() > 1 ? " " + row.backend : "") +
               (row.is_default ? " *" : "");
    };
    std::map<std::string, std::map<std::string, double>> cells;
    std::size_t width = 0;
    for (const StabilityRow& row : rows) {
        add_once(workloads, row.workload);
        add_once(methods, name(row));
        cells[row.workload][name(row)] = per_million(row);
        width = std::max(width, row.workload.size());
    }
    std::string out = "failures per million rays; . none, * what runs use by default\n";
    for (std::size_t m = 0; m < methods.size(); ++m)
        out += "  " + std::string(1, static_cast<char>(m < 26 ? 'A' + m : 'a' + m - 26)) + "  " + methods[m] +
               "\n";
    const auto pad = [](std::string text, std::size_t n) {
        return text.insert(0, n - std::min(n, text.size()), ' ');
    };
    out += std::string(width, ' ');
    for (std::size_t m = 0; m < methods.size(); ++m)
        out += pad(std::string(1, static_cast<char>(m < 26 ? 'A' + m : 'a' + m - 26)), 6);
    out += "\n";
    for (const std::string& workload : workloads) {
        out += workload + std::string(width - workload.size(), ' ');
        for (const std::string& method : methods) {
            const auto cell = cells[workload].find(method);
            out += pad(cell == cells[workload].end() ? "-" : short_count(cell->second), 6);
        }
        out += "\n";
    }
    return out;
}

}  // namespace ctpbench
