// SPDX-License-Identifier: Apache-2.0
// Converts runs of a system's reduced or minimised forms to runs of the system. For reduced forms it inserts the
// confluent steps that were followed, and restores the original place of every replica (docs/search.md, "Confluent
// taus", "Symmetry").
#pragma once

#include <optional>

#include "checker/lts/symmetry.hpp"
#include "checker/lts/transition_system.hpp"
#include "checker/refine/search/budget.hpp"
#include "checker/refine/search/run.hpp"
#include "checker/refine/verdict/findings.hpp"

namespace robochart::refine {

/// The reductions that were applied to a system. If a member is null, its reduction was not applied. Steps are followed
/// before states are replaced by their symmetric representatives.
struct Reduction {
    lts::ReducedSystem* steps = nullptr;
    lts::Symmetry* symmetry = nullptr;
};

/// Converts a violation of the reduced form to a violation of the system.
[[nodiscard]] Violation unfold_violation(lts::TransitionSystem& system, const Reduction& reduction,
                                         const Violation& shown);

/// Converts a violation of a minimised system to a violation of the finer system, that is, the system before its
/// minimisation. The result has the names of hidden events in the finer system. Returns no value if the finer system
/// does not have the run. (Then the minimisation is wrong.)
[[nodiscard]] std::optional<Violation> refine_violation(lts::FinerSystem& finer, const Violation& shown,
                                                        Budget& budget);

}  // namespace robochart::refine
