// Counterexamples from runs.
#pragma once

#include "checker/refine/verdict/reference.hpp"
#include "checker/refine/verdict/verdict.hpp"

namespace robochart::refine {

/// The violation with its states described; `required` is left to the caller.
[[nodiscard]] Counterexample tell(const Confirmed& confirmed);
/// Nondeterminism: the run that accepts what the counterexample's refuses.
void tell_accepting(const Confirmed& accepting, Counterexample& counterexample);

}  // namespace robochart::refine
