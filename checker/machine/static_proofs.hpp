// SPDX-License-Identifier: Apache-2.0
// Proves facts about all states of a compiled process from its rules and components, without a search. docs/search.md,
// "Static proofs", contains the statements and the proofs.
#pragma once

#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/machine/whole_rules.hpp"

namespace robochart::machine {

/// Returns for each rule whether its transitions may lie on a cycle of taus. If the value is false, no transition of a
/// reachable state by this rule lies on such a cycle. Polls the budget.
[[nodiscard]] std::vector<bool> rules_on_tau_cycles(const Supercombinator& combined, const WholeRules& rules,
                                                    diagnostics::Pollable& budget);

/// Returns true if the rules show that no state has a tau, two transitions with the same event, or tick together with
/// another event.
[[nodiscard]] bool exclude_choices(const Supercombinator& combined, const WholeRules& rules);

}  // namespace robochart::machine
