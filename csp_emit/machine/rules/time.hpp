// Time (semantics 3.10): one tock is one unit. A configuration lets time pass unless something in it is urgent: a
// hidden step, a call of a platform operation, a deadline that has run out. Clocks saturate one above the largest
// value they are compared with (clock_limits.hpp), waits and deadlines count down.
#pragma once

#include <utility>
#include <vector>

#include "csp_emit/machine/rules/statements.hpp"

namespace robochart::csp_emit {

/// Whether the thread's next event is hidden or urgent, so that time cannot pass before it.
[[nodiscard]] bool stops_time(const MachineTables&, const RunningThread&, bool alone);
/// Whether something must happen before time can pass.
[[nodiscard]] bool urgent(const MachineTables&, const View&);
/// The deadlines of transitions that run: the counter and the transition's guard.
[[nodiscard]] std::vector<std::pair<CellId, cspm::ExprPtr>> monitors(const MachineTables&, const View&, const Values&);
/// The values with which a configuration becomes a point: a transition's deadline starts anew whenever its guard is
/// false.
[[nodiscard]] Values with_monitors(const MachineTables&, const Activation& config, const Values&);
/// One unit passes, if every deadline still to be met has time left.
[[nodiscard]] Branch tock(const MachineTables&, const Activation& config, const View&);
/// A wait begins: `wait(n)`, or one of an interval's lengths. Untimed it is nothing (semantics 3.11).
[[nodiscard]] Next start_wait(MachineTables&, const RunningThread&, const ir::Stmt&, const Program& rest,
                              const Values&);
/// The clocks of the caller that guards of the running machines ask for here, in order of declaration. An operation on
/// its own asks for them one after the other before its guards are evaluated, and again when time has passed
/// (`get_CLID_C?C -> TimeOut_1(choices, SKIP) ; Trans`).
[[nodiscard]] std::vector<CellId> clocks_needed(const MachineTables&, const View&);

}  // namespace robochart::csp_emit
