// `ctpbench compare BASE NEW`: two folders of results beside each other, and an exit code that a script can
// act upon.
#pragma once

#include "base/error.h"
#include "config/command_line.h"

namespace ctpbench {

// regression, or with --strict unclear; throws Error(usage) if nothing can be compared.
ExitCode compare(const CommandLine& line);

}  // namespace ctpbench
