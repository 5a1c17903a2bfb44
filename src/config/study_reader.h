// Reads what a config asks, and the settings that only one study has.
#pragma once

#include "base/json_reader.h"
#include "config/config.h"

namespace ctpbench {

// Sets `study`, `measure` and the study's own settings; errors go to the object's reader. The axes' meaning
// depends on these: read them first.
void read_study(const JsonObject& root, const KnownNames& known, Config& config);

}  // namespace ctpbench
