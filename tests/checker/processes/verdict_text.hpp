// SPDX-License-Identifier: Apache-2.0
// Prints verdicts, so that tests can compare two searches.
#pragma once

#include <string>

#include "checker/refine/verdict/verdict.hpp"

namespace robochart::refine {

/// Returns the complete verdict as text: outcome, reason, figures, and for a counterexample its kind and every step
/// with its state.
[[nodiscard]] std::string complete_text(const Verdict& verdict);

}  // namespace robochart::refine
