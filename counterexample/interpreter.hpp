// SPDX-License-Identifier: Apache-2.0
// Converts a counterexample of the checker to a run in terms of the model. A step is described by the actions of the
// sequential components that take part in it, with the components' own names of the event. So renaming, hiding and
// priority around a component (in a check, a composition or a CSP block) do not affect the description.
#pragma once

#include "counterexample/run.hpp"
#include "counterexample/step_reader.hpp"
#include "csp_emit/emit.hpp"

namespace robochart::runs {

/// Returns the run of a counterexample to one of the obligation's assertions, with the violation at its end.
[[nodiscard]] Run interpret_counterexample(const Context&, const csp_emit::Obligation&, const refine::Counterexample&);

}  // namespace robochart::runs
