// SPDX-License-Identifier: Apache-2.0
// Transitions (semantics 3.4): all enabled ones of the active node and of its active ancestors are in one external
// choice; then trigger, store, clock resets, exits innermost first, action, entry, in this order.
#pragma once

#include <vector>

#include "csp_emit/machine/rules/statements.hpp"

namespace robochart::csp_emit {

/// The outgoing transitions of a settled machine: those of its active node and of all enclosing states.
[[nodiscard]] std::vector<ir::TransitionId> candidates(const MachineTables&, const Activation&);
/// Whether a transition without trigger and condition is enabled; it fires before time passes.
[[nodiscard]] bool has_urgent_transition(const MachineTables&, const Activation&);
/// The guard with the preconditions of its functions; `true` if there is none. In the untimed semantics, conditions
/// that read clocks are left out.
[[nodiscard]] cspm::ExprPtr guard_of(const MachineTables&, std::uint32_t frame, const ir::Transition&, const Values&,
                                     const cspm::ExprPtr& trigger_value);
/// Fires the transition: `g & e.in?x:{x | x <- T, guard(x)}`, where values that fail the guard are refused, not
/// consumed; without a trigger by a hidden event, `g & internal__.TID_t`.
[[nodiscard]] Branch fire(MachineTables&, const RunningMachine&, ir::TransitionId);

}  // namespace robochart::csp_emit
