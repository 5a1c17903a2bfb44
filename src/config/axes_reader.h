// Reads the axes of a config's `matrix`, or of an entry of its `exclude` or `include`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/json_reader.h"
#include "config/config.h"

namespace ctpbench {

// The names along an axis of names; of scenes, which only loading shows, none.
std::vector<std::string> axis_choices(std::string_view axis, const KnownNames& known);

// What the values of an axis of numbers may be.
Range axis_range(std::string_view axis);

// Why the axis means nothing in a config that asks this; empty if it means something. Needs `study` and
// `measure` alone.
std::string meaningless(std::string_view axis, const Config& config);

// Replaces the axes that the object gives and leaves the others; errors go to the object's reader.
void read_axes(const JsonObject& object, const Config& config, const KnownNames& known, Axes& axes);

}  // namespace ctpbench
