#include "report/judgement.h"

#include <algorithm>

#include "measure/finding.h"
#include "report/figures.h"

namespace ctpbench {
namespace {

// By round, what a cell is judged by, and whether that is a ratio to the reference.
struct Basis {
    std::vector<double> values;
    bool compares = false;
};

Basis basis_of(const CellResult& cell, const Results& results, const std::string& reference,
               std::string_view kernel) {
    const CellResult* other = reference_of(cell, results, reference);
    const bool compares = other != &cell;
    if (compares)
        if (std::vector<double> ratios = ratios_of(&cell, other, kernel); !ratios.empty())
            return {std::move(ratios), true};
    const CellResult* yardstick = yardstick_of(cell, results);
    if (yardstick != &cell)
        if (std::vector<double> ratios = ratios_of(&cell, yardstick, kernel); !ratios.empty())
            return {std::move(ratios), false};
    const KernelSeries* series = cell.valid ? cell.find(kernel) : nullptr;
    return {series == nullptr ? std::vector<double>() : series->mrays, false};
}

}  // namespace

Judgements::Judgements(const Config& config, const Results& results) {
    std::vector<std::size_t> compared;
    std::vector<Claims> claims;
    std::size_t fewest = max_rounds;
    for (const CellResult& cell : results.cells)
        for (const KernelSeries& k : cell.kernels) {
            const Basis basis = basis_of(cell, results, config.reference, k.kernel);
            lines_.push_back({&cell, k.kernel, {"", flags_of(basis.values)}});
            if (!basis.compares || k.kernel != main_kernel(cell)) continue;
            compared.push_back(lines_.size() - 1);
            claims.push_back(claims_of(basis.values));
            fewest = std::min(fewest, basis.values.size());
        }
    const std::vector<Finding> found = findings(claims);
    for (std::size_t i = 0; i < found.size(); ++i) lines_[compared[i]].judgement.verdict = name_of(found[i]);
    if (const std::size_t needed = rounds_for(found.size()); !found.empty() && fewest < needed)
        shortage_ = std::to_string(found.size()) + " comparisons need " + std::to_string(needed) +
                    " rounds before each can have a verdict; there were " + std::to_string(fewest);
}

const Judgement* Judgements::find(const CellResult& cell, std::string_view kernel) const {
    for (const Line& line : lines_)
        if (line.cell == &cell && line.kernel == kernel) return &line.judgement;
    return nullptr;
}

std::vector<std::string> Judgements::warnings() const {
    std::vector<std::string> out;
    for (const Line& line : lines_)
        if (line.judgement.flags.any())
            out.push_back(line.cell->workload.name() + "/" + line.cell->contender.label() + ", " +
                          line.kernel + ": doubtful: " + line.judgement.flags.text());
    if (!shortage_.empty()) out.push_back(shortage_);
    return out;
}

double noise_of(const CellResult& cell, const Results& results, const std::string& reference) {
    const Basis basis = basis_of(cell, results, reference, main_kernel(cell));
    if (basis.values.empty()) return 0.0;
    const Estimate e = estimate_median(basis.values);
    return 0.5 * (e.hi - e.lo) / e.median;
}

}  // namespace ctpbench
