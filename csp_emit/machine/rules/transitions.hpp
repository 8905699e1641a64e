// SPDX-License-Identifier: Apache-2.0
// Transitions (semantics 3.4): one external choice contains all enabled transitions of the active node and of its
// active ancestors. A transition then runs its trigger, the store, the clock resets, the exits (innermost first), the
// action and the entry, in this order.
#pragma once

#include <vector>

#include "csp_emit/machine/rules/statements.hpp"

namespace robochart::csp_emit {

/// The outgoing transitions of a settled machine: those of its active node and of all enclosing states.
[[nodiscard]] std::vector<ir::TransitionId> outgoing_transitions(const MachineTables&, const Activation&);
/// Whether a transition without trigger and condition is enabled; it fires before time passes.
[[nodiscard]] bool has_urgent_transition(const MachineTables&, const Activation&);
/// The guard with the preconditions of its functions; `true` if there is none. The untimed semantics omits conditions
/// that read clocks.
[[nodiscard]] cspm::ExprPtr guard_of(const MachineTables&, std::uint32_t frame, const ir::Transition&, const Values&,
                                     const cspm::ExprPtr& trigger_value);
/// Fires the transition. With a trigger: `g & e.in?x:{x | x <- T, guard(x)}`, which refuses values that fail the guard
/// instead of consuming them. Without a trigger: a hidden event, `g & internal__.TID_t`.
[[nodiscard]] Branch fire_transition(MachineTables&, const RunningMachine&, ir::TransitionId);

}  // namespace robochart::csp_emit
