// SPDX-License-Identifier: Apache-2.0
// Finds the violation of a compiled process again in the terms from which the process was compiled, so that the two
// engines check each other. If the terms do not have the violation, there is an internal error, and the functions throw
// std::logic_error.
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
    std::shared_ptr<lts::FinerSystem> finer = nullptr;  ///< owns `system` if it is a finer system
};

/// A function that confirms a violation of a system, or throws std::logic_error.
using Judge = std::function<void(lts::TransitionSystem&, const Violation&, Budget&)>;

/// Replays the violation in the system. If the system has a reference, also replays it in the reference and returns the
/// violation of the reference. `judge` is one of the confirm functions of replay.hpp; its argument is the system to
/// which the states of the runs belong. If the search in the reference takes too long, returns the violation of the
/// system before minimisation (the finer system), because hidden events have the right names there. If there is no
/// finer system, or if the computation of the finer system takes too long, returns the violation of the system itself.
[[nodiscard]] Confirmed confirm_violation(lts::TransitionSystem& system, const Violation& violation, Budget& budget,
                                          const Judge& judge);

/// Returns a violation of the reference whose run has the same trace and ends in a state with the same fault. Public
/// for tests.
[[nodiscard]] Violation found_again(lts::TransitionSystem& system, lts::TransitionSystem& reference,
                                    const Violation& violation, Budget& budget);

}  // namespace robochart::refine
