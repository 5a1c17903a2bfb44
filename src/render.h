// `ctpbench render`: one scene through its camera into an image, by the same kernels that are measured.
#pragma once

#include "base/error.h"
#include "config/command_line.h"

namespace ctpbench {

// Ctrl-C ends it early: the samples so far are written, and the code is `interrupted`. Throws Error(output),
// also if built without OpenImageIO.
ExitCode render(const CommandLine& line);

}  // namespace ctpbench
