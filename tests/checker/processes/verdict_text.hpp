// Verdicts as texts, so that two searches can be compared.
#pragma once

#include <string>

#include "checker/refine/verdict/verdict.hpp"

namespace robochart::refine {

/// All that a verdict says: outcome, reason, figures, and of a counterexample its kind and every step with its state.
[[nodiscard]] std::string everything(const Verdict& verdict);

}  // namespace robochart::refine
