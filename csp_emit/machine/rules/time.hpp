// SPDX-License-Identifier: Apache-2.0
// Applies the rules for time (semantics 3.10). One tock is one time unit. A configuration lets time pass unless
// something in it is urgent: a hidden step, a call of a platform operation, an expired deadline. A clock saturates one
// above the largest value with which it is compared (clock_limits.hpp). Waits and deadlines count down.
#pragma once

#include <utility>
#include <vector>

#include "csp_emit/machine/rules/statements.hpp"

namespace robochart::csp_emit {

/// True if the thread's next event is hidden or urgent, so that it happens before time passes.
[[nodiscard]] bool stops_time(const MachineTables&, const RunningThread&, bool alone);
/// True if some event must happen before time can pass.
[[nodiscard]] bool is_urgent(const MachineTables&, const View&);
/// Returns the deadlines of the current transitions: for each, the counter and the transition's guard.
[[nodiscard]] std::vector<std::pair<CellId, cspm::ExprPtr>> active_monitors(const MachineTables&, const View&,
                                                                            const Values&);
/// Returns the values that a configuration passes to the function of its point. A transition's deadline restarts
/// whenever the guard of the transition is false.
[[nodiscard]] Values with_monitors(const MachineTables&, const Activation& config, const Values&);
/// Returns the branch in which one time unit passes. Its guard requires that no pending deadline has expired.
[[nodiscard]] Branch tock_branch(const MachineTables&, const Activation& config, const View&);
/// Starts `wait(n)`, or a wait for one of the lengths in an interval. In the untimed semantics a wait has no effect
/// (semantics 3.11).
[[nodiscard]] Next start_wait(MachineTables&, const RunningThread&, const ir::Stmt&, const Program& rest,
                              const Values&);
/// Returns the clocks of the caller that guards of the running machines read here, in order of declaration. An
/// operation that is checked on its own reads these clocks one after the other before it evaluates its guards, and
/// again after time has passed (`get_CLID_C?C -> TimeOut_1(choices, SKIP) ; Trans`).
[[nodiscard]] std::vector<CellId> clocks_needed(const MachineTables&, const View&);

}  // namespace robochart::csp_emit
