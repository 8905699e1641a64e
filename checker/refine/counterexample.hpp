// Runs told as counterexamples.
#pragma once

#include "checker/refine/replay.hpp"

namespace robochart::refine {

/// The violation with its states described; `required` is left to the caller.
[[nodiscard]] Counterexample tell(lts::TransitionSystem& system, const Violation& violation);

}  // namespace robochart::refine
