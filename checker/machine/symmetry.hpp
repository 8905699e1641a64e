// SPDX-License-Identifier: Apache-2.0
// Finds equal operands of a compiled process that can be exchanged. The graphs of their components suggest which ones;
// all rules are then checked for each proposal (docs/search.md, "Symmetry").
#pragma once

#include "base/diagnostics/pollable.hpp"
#include "checker/lts/symmetry.hpp"
#include "checker/machine/supercombinator.hpp"

namespace robochart::machine {

/// Returns the sets of replicas, large replicas first. Returns an empty list if it finds none, or if components or
/// rules are too large. Polls the budget.
[[nodiscard]] std::vector<lts::ReplicaSet> replica_sets(const Supercombinator& combined, const lts::EventTable& names,
                                                        diagnostics::Pollable& budget);

}  // namespace robochart::machine
