// ctpbench --doctor: what this build and this machine can do, what is missing, and how to get it.
#pragma once

#include "base/error.h"
#include "config/command_line.h"

namespace ctpbench {

// Prints a line for each thing. Fails as a run with these options would: for want of a folder that it can
// write to, of a backend that --backend names, of a mesh with --scenes real.
ExitCode examine(const CommandLine& line);

}  // namespace ctpbench
