// Equal operands of a compiled process that can be exchanged: proposals by the graphs of their components, each
// verified on all rules (docs/search.md, "Symmetry").
#pragma once

#include <functional>

#include "checker/lts/symmetry.hpp"
#include "checker/machine/supercombinator.hpp"

namespace robochart::machine {

/// The sets of replicas that are found, large replicas first. None where components or rules are too large to be looked
/// at. `poll` may throw to stop.
[[nodiscard]] std::vector<lts::ReplicaSet> replica_sets(const Supercombinator& combined, const lts::EventTable& names,
                                                        const std::function<void()>& poll);

}  // namespace robochart::machine
