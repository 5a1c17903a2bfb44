#include "compare.h"

#include <cstdio>

#include "report/comparison.h"

namespace ctpbench {

ExitCode compare(const CommandLine& line) {
    const Comparison comparison = compare(read_results(line.base), read_results(line.fresh), line.fail_ratio);
    if (comparison.kernels.empty()) {
        std::string why;
        for (const std::string& unmatched : comparison.unmatched) why += "\n  " + unmatched;
        throw Error(ExitCode::usage, "ctpbench: error: " + line.base.string() + " and " +
                                         line.fresh.string() +
                                         " have nothing that can be compared; run one config twice" + why);
    }
    std::printf("BASE %s\nNEW  %s\n\n%s", line.base.c_str(), line.fresh.c_str(),
                comparison_text(comparison, line.fail_ratio).c_str());
    if (comparison.has_regression()) return ExitCode::regression;
    return line.strict && comparison.has_doubt() ? ExitCode::unclear : ExitCode::ok;
}

}  // namespace ctpbench
