#include "report/comparison.h"

#include <algorithm>
#include <cstdio>

#include "measure/series_flags.h"
#include "report/figures.h"
#include "report/run_facts.h"

namespace ctpbench {
namespace {

std::vector<double> pooled(const std::vector<std::vector<double>>& runs) {
    std::vector<double> all;
    for (const auto& run : runs) all.insert(all.end(), run.begin(), run.end());
    return all;
}

double middle(const std::vector<std::vector<double>>& runs) {
    std::vector<double> medians;
    for (const auto& run : runs) medians.push_back(median(run));
    return median(medians);
}

// Why two recordings of a kernel cannot be set beside each other; empty if they can.
std::string obstacle(const RecordedKernel& base, const RecordedKernel& fresh) {
    if (!base.valid) return "its hits were rejected in BASE";
    if (!fresh.valid) return "its hits were rejected in NEW";
    if (base.runs.empty() || fresh.runs.empty()) return "no complete round";
    if (base.rays != fresh.rays) return "other rays: bounces or their number of rays differ";
    return {};
}

class Comparer {
public:
    Comparer(const RecordedResults& base, const RecordedResults& fresh, double fail_ratio)
        : base_(base), fresh_(fresh), fail_ratio_(fail_ratio) {}

    Comparison compare() {
        const FactDifferences facts = compare_facts(base_, fresh_);
        out_.differences = facts.lines, out_.other_machine = facts.machine;
        if (facts.yardstick) warn("the yardstick is not the same: another version of Embree");
        for (const RecordedKernel& k : base_.kernels) {
            const RecordedKernel* other = fresh_.find(k.key);
            if (other == nullptr)
                out_.unmatched.push_back(k.name + ": only in BASE");
            else if (const std::string why = obstacle(k, *other); !why.empty())
                out_.unmatched.push_back(k.name + ": " + why);
            else
                compare(k, *other);
        }
        for (const RecordedKernel& k : fresh_.kernels)
            if (base_.find(k.key) == nullptr) out_.unmatched.push_back(k.name + ": only in NEW");
        judge();
        return std::move(out_);
    }

private:
    void warn(const std::string& text) { out_.warnings.push_back(text); }

    void doubt(const RecordedKernel& k, const char* side, const std::vector<std::vector<double>>& runs) {
        std::string doubts;
        const auto flag = [&](const SeriesFlags& flags) {
            if (flags.any()) doubts += (doubts.empty() ? "" : "; ") + flags.text();
        };
        for (const auto& run : runs) flag(flags_of(run));
        if (runs.size() > 1) flag({0.0, flags_of(pooled(runs)).bimodal});
        if (!doubts.empty()) warn(k.name + ": doubtful in " + side + ": " + doubts);
        if (k.incomplete > 0)
            warn(k.name + ": " + std::to_string(k.incomplete) + " rounds in " + side +
                 " lack bounces, and are left out");
    }

    void compare(const RecordedKernel& base, const RecordedKernel& fresh) {
        const RecordedKernel* base_yardstick = base_.yardstick_of(base);
        const RecordedKernel* fresh_yardstick = fresh_.yardstick_of(fresh);
        const bool normalised = base_yardstick != nullptr && fresh_yardstick != nullptr;
        const auto base_runs = speeds_of(base, normalised ? base_yardstick : nullptr);
        const auto fresh_runs = speeds_of(fresh, normalised ? fresh_yardstick : nullptr);
        const std::vector<double> a = pooled(fresh_runs), b = pooled(base_runs);
        if (a.empty() || b.empty()) {
            out_.unmatched.push_back(base.name + ": no round in common with the yardstick");
            return;
        }
        doubt(base, "BASE", base_runs), doubt(fresh, "NEW", fresh_runs);
        differ_ = differ_ || base.hit_hash != fresh.hit_hash;

        ComparedKernel& k = out_.kernels.emplace_back();
        k.name = base.name, k.yardstick = base.yardstick, k.normalised = normalised;
        k.base = middle(base_runs), k.fresh = middle(fresh_runs);
        k.base_rounds = b.size(), k.fresh_rounds = a.size();
        const MedianDistribution numerator(fresh_runs), denominator(base_runs);
        const RatioDistribution ratio(numerator, denominator);
        k.ratio = {k.fresh / k.base, ratio.quantile(0.025), ratio.quantile(0.975)};
        const std::size_t rounds = std::min(a.size(), b.size());
        // Speeds of two machines are no evidence of anything.
        const bool tells = (normalised || !out_.other_machine) && rounds >= kLeastRounds;
        claims_.push_back(tells ? claims_of(ratio, a.size(), b.size()) : Claims{});
        too_few_ = too_few_ || rounds < kLeastRounds;
        absolute_ += !normalised && !k.yardstick;
        if (k.yardstick || !tells) return;
        below_.push_back(claim_below(ratio, fail_ratio_, a.size(), b.size()));
        tested_.push_back(out_.kernels.size() - 1);
    }

    void judge() {
        const std::vector<Finding> found = findings(claims_);
        for (std::size_t i = 0; i < found.size(); ++i) out_.kernels[i].finding = found[i];
        const std::vector<double> adjusted = holm(below_);
        for (std::size_t i = 0; i < adjusted.size(); ++i)
            out_.kernels[tested_[i]].regression = adjusted[i] <= kError;
        if (absolute_ > 0)
            warn(std::to_string(absolute_) + " without a yardstick in the same rounds: " +
                 (out_.other_machine ? "on two machines their speeds tell nothing"
                                     : "their speeds are compared as they are, which a busy machine moves"));
        if (too_few_) warn("fewer than " + std::to_string(kLeastRounds) + " rounds support no verdict");
        if (differ_) warn("hits differ: the two runs traced other rays, or found other hits");
    }

    const RecordedResults& base_;
    const RecordedResults& fresh_;
    double fail_ratio_;
    Comparison out_;
    std::vector<Claims> claims_;  // of every kernel
    std::vector<double> below_;   // of those tested for a regression
    std::vector<std::size_t> tested_;
    std::size_t absolute_ = 0;
    bool too_few_ = false, differ_ = false;
};

}  // namespace

bool Comparison::has_regression() const {
    return std::any_of(kernels.begin(), kernels.end(), [](const ComparedKernel& k) { return k.regression; });
}

bool Comparison::has_doubt() const {
    return !unmatched.empty() || std::any_of(kernels.begin(), kernels.end(), [](const ComparedKernel& k) {
        return !k.yardstick && k.finding == Finding::unclear;
    });
}

Comparison compare(const RecordedResults& base, const RecordedResults& fresh, double fail_ratio) {
    return Comparer(base, fresh, fail_ratio).compare();
}

std::string comparison_text(const Comparison& c, double fail_ratio) {
    std::string out;
    char line[320];
    if (!c.differences.empty()) {
        out += c.other_machine ? "another machine, or one not known (BASE | NEW):\n"
                               : "another build (BASE | NEW):\n";
        for (const std::string& d : c.differences) out += "  " + d + "\n";
        if (c.other_machine)
            out +=
                "  ratios to the yardstick travel better between machines than speeds do, but not without "
                "loss\n";
        out += '\n';
    }
    std::size_t width = 10;
    for (const ComparedKernel& k : c.kernels) width = std::max(width, k.name.size());
    const int columns = static_cast<int>(width);
    std::snprintf(line, sizeof line, "%-*s %16s %16s %11s  %-20s %s\n", columns, "contender", "BASE", "NEW",
                  "rounds", "NEW / BASE", "verdict");
    out += line;
    std::size_t count[4] = {}, regressions = 0;
    for (const ComparedKernel& k : c.kernels) {
        const auto speed = [&](double value) { return fixed(value, 3) + (k.normalised ? " x" : " Mrays/s"); };
        const std::string rounds = std::to_string(k.base_rounds) + ", " + std::to_string(k.fresh_rounds);
        std::snprintf(line, sizeof line, "%-*s %16s %16s %11s  %-20s %s%s\n", columns, k.name.c_str(),
                      speed(k.base).c_str(), speed(k.fresh).c_str(), rounds.c_str(),
                      with_interval(k.ratio).c_str(), name_of(k.finding),
                      k.regression  ? ", REGRESSION"
                      : k.yardstick ? " (yardstick)"
                                    : "");
        out += line;
        if (!k.yardstick) ++count[static_cast<int>(k.finding)], regressions += k.regression;
    }
    if (std::any_of(c.kernels.begin(), c.kernels.end(), [](const ComparedKernel& k) { return k.normalised; }))
        out += "x: times the speed of the yardstick in the same rounds\n";
    for (const std::string& u : c.unmatched) out += "not compared: " + u + "\n";
    for (const std::string& w : c.warnings) out += "warning: " + w + "\n";
    std::snprintf(
        line, sizeof line,
        "\n%zu SAME, %zu FASTER, %zu SLOWER, %zu UNCLEAR, %zu not compared; %zu of them a regression, the "
        "interval's upper end being below %g\n",
        count[static_cast<int>(Finding::same)], count[static_cast<int>(Finding::faster)],
        count[static_cast<int>(Finding::slower)], count[static_cast<int>(Finding::unclear)],
        c.unmatched.size(), regressions, fail_ratio);
    return out + line;
}

}  // namespace ctpbench
