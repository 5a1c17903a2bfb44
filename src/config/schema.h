// The JSON Schema of configs, for editors and other programs: names and ranges are the reader's own. What
// ties several keys together stays the reader's: which axes and settings a study has, what a table needs,
// whether the reference takes part, how many cells there are. In all else a config is accepted by both or by
// neither.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "config/config.h"

namespace ctpbench {

// Of draft 7, which editors know.
nlohmann::ordered_json config_schema(const KnownNames& known);

}  // namespace ctpbench
