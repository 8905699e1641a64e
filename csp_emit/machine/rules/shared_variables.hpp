// SPDX-License-Identifier: Apache-2.0
// Handles shared variables in the machines that require them (semantics 3.7). A machine keeps its own copy of every
// required variable. Other components may write the copy at any moment by set_EXT_x, with three exceptions: during the
// call of a platform operation, while a single event is under a deadline, and after a precondition has failed.
// RoboTool's processes for these cases (`opCall -> SKIP`, `EDeadline`, `false & ...`) do not offer share__. RoboTool
// offers share__ in the steps before them, which read their variables and leave the nodes of a transition
// (`share__choice(exit -> SKIP)`, `share__choice(exited -> SKIP)`).
#pragma once

#include <vector>

#include "csp_emit/machine/rules/statements.hpp"

namespace robochart::csp_emit {

/// True if the call reads variables in a separate step. Other components may write until that step
/// (`share__choice(get_v?v -> ...)`), but not during the call of the operation.
[[nodiscard]] bool reads_in_turn(const MachineTables&, const RunningThread&, const ir::Stmt&);
/// Adds the step that leaves `node`, if this step is observable. `next` is the action that follows, and may be null.
void left_before(const MachineTables&, const ir::StmtPtr& next, ir::NodeId node, const ir::Transition&,
                 std::vector<Item>& items);
/// Adds a step that leaves the source of the transition, if the machine shows its active states. So an observer sees
/// that the state was left, even if the transition enters the same state again. No other component writes before this
/// step.
void left_and_shown(const MachineTables&, std::uint32_t frame, const ir::Transition&, std::vector<Item>& items);
/// Returns the branch for the steps `exit` and `exited` of a node. They do not synchronise with other components, which
/// may write until they happen.
[[nodiscard]] Branch left_branch(MachineTables&, const RunningThread&);

/// Returns the events `set_EXT_x` of all shared variables.
[[nodiscard]] std::vector<cspm::ExprPtr> external_write_events(const MachineTables&);
/// Returns a branch `set_EXT_x?v` for every shared variable, if no thread refuses writes.
[[nodiscard]] std::vector<Branch> external_writes(const MachineTables&, const Activation& config, const View&);

}  // namespace robochart::csp_emit
