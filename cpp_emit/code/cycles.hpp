// SPDX-License-Identifier: Apache-2.0
// Writes code for what a RoboSim machine may do in a cycle (docs/robosim.md, "Meaning"). Members of Step store whether
// the machine has ended the cycle and which outputs the cycle has written. A Step exists for one cycle, so each cycle
// begins without these marks.
#pragma once

#include <string>

#include "cpp_emit/expressions/code_writer.hpp"
#include "cpp_emit/expressions/generation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Returns the member of Step that is true after the machine has ended the cycle.
[[nodiscard]] std::string ended_member(const Component&, const Unit&);
/// Returns the member of Step that is true after the cycle has written the statement's output; "" if it writes no
/// output.
[[nodiscard]] std::string written_member(const Generation&, const Unit&, const ir::Stmt&);
/// Returns whether the machine of the unit has a during action. Such an action runs in parallel with the transitions,
/// even after another action has ended the cycle.
[[nodiscard]] bool has_parallel_actions(const Component&, const Unit&);
/// Returns whether the statement itself may have to wait for the next cycle.
[[nodiscard]] bool may_await_cycle(const Generation&, const Unit&, const ir::Stmt&);
/// Returns the condition for which the statement waits: the cycle has ended, or the output is already written. Returns
/// "" if the statement never waits.
[[nodiscard]] std::string awaits_cycle(const Generation&, const Unit&, const ir::Stmt&);
/// Returns the type of a buffer between machines.
[[nodiscard]] std::string buffer_type(const Generation&, const Buffer&);
/// Writes the code with which a cycle reads the events that machines sent to each other in the previous cycle, and the
/// variables of controllers and platforms.
void read_registers_between_machines(const Generation&, CodeWriter&);
/// Writes the members of Step for the ends of cycles and the written outputs.
void write_cycle_members(const Generation&, CodeWriter&);

}  // namespace robochart::cpp_emit
