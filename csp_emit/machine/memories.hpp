// Which variables are parameters of the machine's process and which have a memory of their own (semantics 3.6).
#pragma once

#include <vector>

#include "csp_emit/machine/tables/machine_tables.hpp"
#include "csp_emit/passes/variable_memory.hpp"

namespace robochart::csp_emit {

/// Largest variables first, as few as make the rest small enough to be parameters (Options::states_of_a_process).
[[nodiscard]] std::vector<Remembered> choose_memories(MachineTables&, const std::vector<Function>& functions);

}  // namespace robochart::csp_emit
