// SPDX-License-Identifier: Apache-2.0
// Writes the code that limits what a RoboSim machine does in a cycle (docs/robosim.md, "Meaning"). Members of Step
// record whether the machine has ended the cycle, and which outputs it has written. A Step exists for one cycle only,
// so the next cycle starts without these records.
#pragma once

#include <string>

#include "cpp_emit/expressions/code_writer.hpp"
#include "cpp_emit/expressions/generation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Returns the member of Step that is true after the machine has ended the cycle.
[[nodiscard]] std::string ended_member(const Component&, const Unit&);
/// Returns the member of Step that is true once the cycle has written the output of this statement. Returns "" if the
/// statement writes no output.
[[nodiscard]] std::string written_member(const Generation&, const Unit&, const ir::Stmt&);
/// Returns true if the machine of the unit has a during action. Such an action continues in parallel with transitions,
/// even after another action has ended the cycle.
[[nodiscard]] bool has_parallel_actions(const Component&, const Unit&);
/// Returns whether the statement itself may have to wait for the next cycle.
[[nodiscard]] bool may_await_cycle(const Generation&, const Unit&, const ir::Stmt&);
/// Returns when the statement must wait: the cycle has ended, or has already written the output. Returns "" if it never
/// waits.
[[nodiscard]] std::string awaits_cycle(const Generation&, const Unit&, const ir::Stmt&);
/// Returns the type of a buffer between machines.
[[nodiscard]] std::string buffer_type(const Generation&, const Buffer&);
/// Writes the code that a cycle runs first. It reads the events that machines sent to each other in the previous cycle,
/// and the variables of controllers and platforms.
void read_registers_between_machines(const Generation&, CodeWriter&);
/// Writes the members of Step for the ends of cycles and the written outputs.
void write_cycle_members(const Generation&, CodeWriter&);

}  // namespace robochart::cpp_emit
