// SPDX-License-Identifier: Apache-2.0
// Applies the rules for statements (semantics 3.5). A statement is executed at once if no other thread or component can
// interfere with it. A statement that reads or writes shared data is a separate step. RoboTool reads all variables of a
// statement at one moment and keeps the values until the statement's event happens. So these values are stored in
// separate cells ("frozen").
#pragma once

#include <optional>

#include "csp_emit/machine/rules/statements.hpp"

namespace robochart::csp_emit {

/// Executes the first item of the configuration that needs no event. Returns no value if there is none. `branching`:
/// the function already contains a conditional.
[[nodiscard]] std::optional<Next> silent_step(MachineTables&, const Activation& config, const Values&, bool branching);
/// Returns the event of the first item of a thread. Returns no value if the thread only waits for time or cannot
/// continue. `alone`: no other thread runs.
[[nodiscard]] std::optional<Branch> head_branch(MachineTables&, const RunningThread&, bool alone);

}  // namespace robochart::csp_emit
