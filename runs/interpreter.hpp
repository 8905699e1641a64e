// From a counterexample of the checker to a run in the words of the model. What a step means is read off what each
// sequential component does in it, under the name that the event has there: renaming, hiding and priority around a
// component (of a check, a composition or a CSP block) change nothing.
#pragma once

#include "csp_emit/emit.hpp"
#include "runs/run.hpp"
#include "runs/step_reader.hpp"

namespace robochart::runs {

/// The run of a counterexample to one of the obligation's assertions, and what is wrong at its end.
[[nodiscard]] Run interpret(const Context&, const csp_emit::Obligation&, const refine::Counterexample&);

}  // namespace robochart::runs
