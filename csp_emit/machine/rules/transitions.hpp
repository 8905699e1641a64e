// SPDX-License-Identifier: Apache-2.0
// Applies the rules for transitions (semantics 3.4). One external choice contains all enabled transitions of the active
// node and of its active ancestors. A transition then runs its trigger, the store, the clock resets, the exits
// (innermost first), the action and the entry, in this order.
#pragma once

#include <vector>

#include "csp_emit/machine/rules/statements.hpp"

namespace robochart::csp_emit {

/// Returns the outgoing transitions of a settled machine: those of its active node and of all enclosing states.
[[nodiscard]] std::vector<ir::TransitionId> outgoing_transitions(const MachineTables&, const Activation&);
/// True if a transition without trigger and condition is enabled. It fires before time passes.
[[nodiscard]] bool has_urgent_transition(const MachineTables&, const Activation&);
/// Returns the guard with the preconditions of its functions, or `true` if there is none. The untimed semantics omits
/// conditions that read clocks.
[[nodiscard]] cspm::ExprPtr guard_of(const MachineTables&, std::uint32_t frame, const ir::Transition&, const Values&,
                                     const cspm::ExprPtr& trigger_value);
/// Fires the transition. The branch of a transition with a trigger is `g & e.in?x:{x | x <- T, guard(x)}`, which
/// refuses values that fail the guard instead of consuming them. Without a trigger, it is a hidden event, `g &
/// internal__.TID_t`.
[[nodiscard]] Branch fire_transition(MachineTables&, const RunningMachine&, ir::TransitionId);

}  // namespace robochart::csp_emit
