// Reads which tables a run writes, and checks that it will have what they are made from.
#pragma once

#include <vector>

#include "base/json_reader.h"
#include "config/cells.h"
#include "config/config.h"

namespace ctpbench {

// Those that are named. Needs `measure`.
void read_tables(const JsonObject& root, const KnownNames& known, Config& config);

// Of a study of speed with these cells: the default tables where none are named; errors where a table or what
// goes with one needs other cells.
void check_tables(const JsonObject& root, const std::vector<Cell>& cells, const KnownNames& known,
                  Config& config);

}  // namespace ctpbench
