// SPDX-License-Identifier: Apache-2.0
// Chooses which variables are parameters of the machine's process and which get a memory process (semantics 3.6).
#pragma once

#include <vector>

#include "csp_emit/machine/tables/machine_tables.hpp"
#include "csp_emit/passes/variable_memory.hpp"

namespace robochart::csp_emit {

/// Chooses the variables that get memories. It takes the largest variables, and only as many as necessary: the process
/// with all others as parameters must be small enough (Options::states_of_a_process).
[[nodiscard]] std::vector<Remembered> choose_memories(MachineTables&, const std::vector<Function>& functions);

}  // namespace robochart::csp_emit
