// Statements (semantics 3.5). A statement that nothing can interfere with is done at once; one that reads or
// writes shared data is a step of its own: RoboTool reads all variables of a statement at one moment and keeps what
// it read until the statement's event happens, so a value read is frozen in a cell of its own.
#pragma once

#include <optional>

#include "csp_emit/machine/rules/statements.hpp"

namespace robochart::csp_emit {

/// The first thing in the configuration that needs no event, done; none if everything needs one. `branching`: a
/// conditional has been written already.
[[nodiscard]] std::optional<Next> silent(MachineTables&, const Activation& config, const Values&, bool branching);
/// The event of the head of a thread; none if it moves with time only, or never. `alone`: no other thread runs.
[[nodiscard]] std::optional<Branch> head_branch(MachineTables&, const RunningThread&, bool alone);

}  // namespace robochart::csp_emit
