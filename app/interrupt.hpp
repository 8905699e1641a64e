// Ctrl-C and SIGTERM: while a check runs it is asked to stop and ends with an honest "inconclusive"; a second signal,
// or one outside a check, ends the program at once.
#pragma once

namespace robochart::app {

/// While it lives, the first SIGINT or SIGTERM only sets `interrupted`.
class InterruptScope {
public:
    InterruptScope();
    ~InterruptScope();
    InterruptScope(const InterruptScope&) = delete;
    InterruptScope& operator=(const InterruptScope&) = delete;
};

/// True once either signal has arrived in some scope.
[[nodiscard]] bool interrupted();

}  // namespace robochart::app
