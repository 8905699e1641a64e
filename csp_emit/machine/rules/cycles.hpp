// SPDX-License-Identifier: Apache-2.0
// Determines the steps of a RoboSim machine in its cycles (docs/robosim.md). Between `endexec` and `startexec` the
// machine takes no transition and does not access its registers itself. Instead, its registers are read, time passes,
// and a machine in its final state may terminate. The process of the cycle (csp_emit/base/registers.hpp) determines the
// order of these events.
#pragma once

#include <vector>

#include "csp_emit/machine/rules/statements.hpp"

namespace robochart::csp_emit {

/// True if some thread has ended the cycle.
[[nodiscard]] bool is_between_cycles(const View&);
/// True if the first item of the thread reads or writes a register, or ends the cycle.
[[nodiscard]] bool touches_registers(const MachineTables&, const RunningThread&);
/// Returns the branch for the statement `exec`: the event `endexec`, after which the thread waits for the next cycle.
[[nodiscard]] Branch end_cycle(const RunningThread&);
/// Returns the initial configuration of a state machine: the first cycle has not begun.
[[nodiscard]] Activation before_first_cycle(const ir::Machine&);
/// Returns all events that the configuration offers.
[[nodiscard]] std::vector<Branch> cycle_branches(MachineTables&, const Activation& config);

}  // namespace robochart::csp_emit
