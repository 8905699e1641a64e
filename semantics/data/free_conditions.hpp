// SPDX-License-Identifier: Apache-2.0
// Conditions whose answers no class of values gives. Private to this component.
//
// Such a condition becomes a Boolean variable. Each write of a variable that the condition reads is followed by an
// internal choice of the answer. Statement: the system refines the resulting one in traces, failures and divergences,
// if values of events are not observed. Reason: each answer of the condition is one of the two alternatives, so the
// system behaves as one resolution of the choices, and all operators are monotone with respect to refinement.
// Prioritisation is not; but the choices are internal steps, which happen before time passes, and a resolved state has
// the same branches as the state of the system. This is the internal form of the may branches of Larsen and Thomsen, A
// modal process logic, 1988, and of predicate abstraction (Graf and Saidi, CAV 1997). See docs/data.md, "Computed
// data".
#pragma once

#include <cstddef>
#include <set>

#include "semantics/data/places.hpp"
#include "semantics/data/sampling.hpp"

namespace robochart::ir {

/// A system in which variables hold the answers of conditions.
struct FreedSystem {
    System system;
    std::size_t conditions = 0;  ///< the number of these variables
};

/// Frees the conditions that read values of several places or may be undefined, and those of `unanswered`, which are
/// expressions of this system. Conditions that cannot be freed stay: those that read a clock, a received value before
/// it is stored, or a variable that other components may write. A statement whose expression may be undefined may
/// block.
[[nodiscard]] FreedSystem free_conditions(const System& system, const Sampling& sampling,
                                          const std::set<const Expr*>& unanswered);

}  // namespace robochart::ir
