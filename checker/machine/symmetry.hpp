// SPDX-License-Identifier: Apache-2.0
// Finds equal operands of a compiled process that can be exchanged. The graphs of their components give proposals; each
// proposal is verified with all rules (docs/search.md, "Symmetry").
#pragma once

#include "base/diagnostics/pollable.hpp"
#include "checker/lts/symmetry.hpp"
#include "checker/machine/supercombinator.hpp"

namespace robochart::machine {

/// Returns the sets of replicas that were found, large replicas first. Returns an empty list if components or rules are
/// too large to be examined. Polls the budget.
[[nodiscard]] std::vector<lts::ReplicaSet> replica_sets(const Supercombinator& combined, const lts::EventTable& names,
                                                        diagnostics::Pollable& budget);

}  // namespace robochart::machine
