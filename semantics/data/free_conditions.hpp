// SPDX-License-Identifier: Apache-2.0
// Handles conditions whose answers do not follow from classes of values. Private to this component.
//
// Such a condition becomes a Boolean variable. After each write of a variable that the condition reads, an internal
// choice sets the answer. Statement: the original system refines the resulting system in traces, failures and
// divergences, if values of events are not observed. Reason: the answer of the condition is always one of the two
// alternatives. So the system behaves as if the choices were resolved in one particular way, and all operators except
// prioritisation are monotone with respect to refinement. For prioritisation: the choices are internal steps, which
// happen before time passes. When they are resolved, the state has the same branches as the corresponding state of the
// original system. This is the internal form of may branches (Larsen and Thomsen, A modal process logic, 1988) and of
// predicate abstraction (Graf and Saidi, CAV 1997). See docs/data.md, "Computed data".
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

/// Replaces conditions by variables with free answers. Replaces those that read several places or may be undefined, and
/// those in `unanswered`, which must be expressions of `system`. Does not replace a condition that reads a clock, a
/// received value before it is stored, or a variable that other components may write. A statement of the result may
/// block if one of its expressions may be undefined.
[[nodiscard]] FreedSystem free_conditions(const System& system, const Sampling& sampling,
                                          const std::set<const Expr*>& unanswered);

}  // namespace robochart::ir
