// SPDX-License-Identifier: Apache-2.0
// Proves facts about all states of a compiled process without a search. The proofs use only the rules and the
// components. docs/search.md, "Static proofs", contains the statements and their proofs.
#pragma once

#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/machine/whole_rules.hpp"

namespace robochart::machine {

/// Returns for each rule whether its transitions may be on a cycle of taus. If the entry of a rule is false, it is
/// proved that no transition by this rule in a reachable state is on such a cycle. Polls the budget.
[[nodiscard]] std::vector<bool> rules_on_tau_cycles(const Supercombinator& combined, const WholeRules& rules,
                                                    diagnostics::Pollable& budget);

/// Returns true if the rules prove that no state has a tau, two transitions with the same event, or tick together with
/// another event.
[[nodiscard]] bool exclude_choices(const Supercombinator& combined, const WholeRules& rules);

}  // namespace robochart::machine
