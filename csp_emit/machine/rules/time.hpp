// SPDX-License-Identifier: Apache-2.0
// Time (semantics 3.10): one tock is one unit. A configuration lets time pass unless something in it is urgent: a
// hidden step, a call of a platform operation, an expired deadline. Clocks saturate one above the largest value that
// they are compared with (clock_limits.hpp); waits and deadlines count down.
#pragma once

#include <utility>
#include <vector>

#include "csp_emit/machine/rules/statements.hpp"

namespace robochart::csp_emit {

/// Whether the thread's next event is hidden or urgent, so that it happens before time passes.
[[nodiscard]] bool stops_time(const MachineTables&, const RunningThread&, bool alone);
/// Whether some event must happen before time can pass.
[[nodiscard]] bool is_urgent(const MachineTables&, const View&);
/// The deadlines of the current transitions: the counter and the transition's guard.
[[nodiscard]] std::vector<std::pair<CellId, cspm::ExprPtr>> active_monitors(const MachineTables&, const View&,
                                                                            const Values&);
/// The values that a configuration passes to the function of its point. A transition's deadline restarts whenever the
/// guard of the transition is false.
[[nodiscard]] Values with_monitors(const MachineTables&, const Activation& config, const Values&);
/// The branch in which one time unit passes, if no pending deadline has expired.
[[nodiscard]] Branch tock_branch(const MachineTables&, const Activation& config, const View&);
/// Starts `wait(n)`, or a wait for one of the lengths in an interval. In the untimed semantics a wait has no effect
/// (semantics 3.11).
[[nodiscard]] Next start_wait(MachineTables&, const RunningThread&, const ir::Stmt&, const Program& rest,
                              const Values&);
/// The clocks of the caller that guards of the running machines read here, in order of declaration. An operation that
/// is checked on its own reads these clocks one after the other before it evaluates its guards, and again after time
/// has passed (`get_CLID_C?C -> TimeOut_1(choices, SKIP) ; Trans`).
[[nodiscard]] std::vector<CellId> clocks_needed(const MachineTables&, const View&);

}  // namespace robochart::csp_emit
