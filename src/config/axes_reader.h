// Reads the axes of a config's `matrix`, or of an entry of its `exclude` or `include`.
#pragma once

#include "base/json_reader.h"
#include "config/config.h"

namespace ctpbench {

// Replaces the axes that the object gives and leaves the others; errors go to the object's reader.
void read_axes(const JsonObject& object, bool measure, const KnownNames& known, Axes& axes);

}  // namespace ctpbench
