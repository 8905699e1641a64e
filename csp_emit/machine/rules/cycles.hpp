// SPDX-License-Identifier: Apache-2.0
// RoboSim: the steps of a machine in its cycles (docs/robosim.md). Between `endexec` and `startexec` the machine takes
// no transition and does not access its registers itself; its registers are read, time passes, and a machine in its
// final state may terminate. The process of the cycle (csp_emit/base/registers.hpp) determines when each of these
// happens.
#pragma once

#include <vector>

#include "csp_emit/machine/rules/statements.hpp"

namespace robochart::csp_emit {

/// Whether some thread has ended the cycle.
[[nodiscard]] bool is_between_cycles(const View&);
/// Whether the first item of the thread reads or writes a register, or ends the cycle.
[[nodiscard]] bool touches_registers(const MachineTables&, const RunningThread&);
/// The branch for the statement `exec`: the event `endexec`, after which the thread waits for the next cycle.
[[nodiscard]] Branch end_cycle(const RunningThread&);
/// The initial configuration of a state machine: the first cycle has not begun.
[[nodiscard]] Activation before_first_cycle(const ir::Machine&);
/// All events that the configuration offers.
[[nodiscard]] std::vector<Branch> cycle_branches(MachineTables&, const Activation& config);

}  // namespace robochart::csp_emit
