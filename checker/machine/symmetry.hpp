// SPDX-License-Identifier: Apache-2.0
// Finds equal operands of a compiled process that can be exchanged. The graphs of the components suggest pairs of
// operands. For each pair, all rules are then checked (docs/search.md, "Symmetry").
#pragma once

#include "base/diagnostics/pollable.hpp"
#include "checker/lts/symmetry.hpp"
#include "checker/machine/supercombinator.hpp"

namespace robochart::machine {

/// Returns the sets of replicas, large replicas first. The list is empty if there are no replicas, or if there are too
/// many states or rules. Polls the budget.
[[nodiscard]] std::vector<lts::ReplicaSet> replica_sets(const Supercombinator& combined, const lts::EventTable& names,
                                                        diagnostics::Pollable& budget);

}  // namespace robochart::machine
