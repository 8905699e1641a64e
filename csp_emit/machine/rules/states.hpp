// SPDX-License-Identifier: Apache-2.0
// Applies the rules for states (semantics 3.3). The entry of a state runs the entry action, then the inner initial
// node, then the `entered` events, innermost first. `entered` starts the during action and makes the state
// interruptible.
#pragma once

#include "csp_emit/machine/rules/statements.hpp"

namespace robochart::csp_emit {

/// True if the machine or operation has reached its own final state.
[[nodiscard]] bool is_final(const MachineTables&, const Activation&);
/// True if the machine is in the state: from the beginning of its entry action until a transition leaves it.
[[nodiscard]] bool is_in(const MachineTables&, const Activation&, ir::NodeId state);
/// Lets the thread enter a node: adds the items that the thread then executes. Those of the innermost node come last.
[[nodiscard]] Next enter_node(const MachineTables&, const RunningThread&, const Values&);
/// Adds a state to the entered states, outermost first, and starts its during action and its clock.
[[nodiscard]] Next mark_entered(const MachineTables&, const RunningThread&, const Values&);
/// Performs this step as the visible event `S::entered`.
[[nodiscard]] Branch entered_branch(const MachineTables&, const RunningThread&);

}  // namespace robochart::csp_emit
