// Ctrl-C: checks poll it and end with an honest "inconclusive"; a second one ends the program at once.
#pragma once

namespace robochart::app {

/// Installs the handlers of SIGINT and SIGTERM.
void catch_interrupts();
/// True once either signal has arrived.
[[nodiscard]] bool interrupted();

}  // namespace robochart::app
