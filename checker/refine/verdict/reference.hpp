// SPDX-License-Identifier: Apache-2.0
// Finds the violation of a compiled process again in the terms from which it was compiled, so that the two engines
// check each other. If the terms do not have the violation, this is an internal error, and std::logic_error is thrown.
#pragma once

#include <functional>
#include <memory>

#include "checker/refine/verdict/replay.hpp"
#include "checker/refine/verdict/verdict.hpp"

namespace robochart::refine {

/// A violation and the system to which the states of its runs belong.
struct Confirmed {
    Violation violation;
    lts::TransitionSystem* system;
    bool by_terms = false;
    std::shared_ptr<lts::FinerSystem> finer = nullptr;  ///< owns `system` if that is a finer system
};

/// Confirms a violation of a system, or throws std::logic_error.
using Judge = std::function<void(lts::TransitionSystem&, const Violation&, Budget&)>;

/// Replays the violation in the system and, if the system has a reference, in the reference. The returned violation is
/// then that of the reference. `judge` is one of the confirm functions of replay.hpp; its argument is the system to
/// which the states of the runs belong. If the reference needs more than its share of time, the returned violation is
/// that of the system before minimisation, so that its hidden events have the right names. It is that of the system
/// itself if there is no finer system, or if computing it takes too long.
[[nodiscard]] Confirmed confirm_violation(lts::TransitionSystem& system, const Violation& violation, Budget& budget,
                                          const Judge& judge);

/// Returns a run of the reference with the same trace that ends in a state of the same kind. Public for tests.
[[nodiscard]] Violation found_again(lts::TransitionSystem& system, lts::TransitionSystem& reference,
                                    const Violation& violation, Budget& budget);

}  // namespace robochart::refine
