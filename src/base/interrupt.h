// Ctrl-C: the first asks the run to stop at the next safe point, the second ends it at once.
#pragma once

namespace ctpbench {

// Installs the handler for SIGINT and SIGTERM.
void watch_for_interrupt();
bool interrupted();

}  // namespace ctpbench
