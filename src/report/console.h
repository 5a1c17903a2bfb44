// The results of a run as text, for its end on a terminal.
#pragma once

#include <string>

#include "config/config.h"
#include "measure/results.h"

namespace ctpbench {

std::string table_text(const Config& config, const Results& results);

}  // namespace ctpbench
