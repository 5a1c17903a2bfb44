// Where and with what two folders of results were measured, as far as that bears on their comparison.
#pragma once

#include <string>
#include <vector>

#include "report/recorded_results.h"

namespace ctpbench {

struct FactDifferences {
    std::vector<std::string> lines;  // `cpu: AMD EPYC 9654 | Intel Xeon 8480`
    bool machine = false;            // it was another one, or is not known
    bool yardstick = false;          // another version of Embree
};

FactDifferences compare_facts(const RecordedResults& base, const RecordedResults& fresh);

}  // namespace ctpbench
