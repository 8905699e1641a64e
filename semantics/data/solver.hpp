// SPDX-License-Identifier: Apache-2.0
// Values that give every possible combination of answers to conditions that are neither linear nor about windows, such
// as `x * x + y * y < 4.0`, found by the solver Z3 (de Moura and Bjørner, Z3: an efficient SMT solver, TACAS 2008).
// Private to this component.
//
// Statement: if there is a result, it contains a value for each combination of answers that some value gives. Reason:
// the solver is asked for a value with a combination that no earlier value has, until it proves that there is none. The
// evaluator of the semantics evaluates each value again, and there is no result if it disagrees with the solver. There
// is also no result if the solver answers "unknown", or if only numbers that are not decimals give some combination (`x
// * x == 2.0`). The solver has limits on its steps and on its time, so that a slow machine may find no result where a
// fast one does.
#pragma once

#include <optional>
#include <vector>

#include "semantics/data/sampling.hpp"
#include "semantics/data/uses.hpp"

namespace robochart::ir {

/// A value of the type for each combination of answers that its values give. No value if the program was built without
/// Z3 (has_solver), an operator of a condition is not arithmetic, logic or a comparison of numbers, an operand may be
/// undefined, or there are more than 4,096 combinations. The search polls the budget of `sampling`.
[[nodiscard]] std::optional<std::vector<Value>> solve_answers(const System& system, const Sampling& sampling,
                                                              TypeId type, const std::vector<Condition>& conditions);

}  // namespace robochart::ir
