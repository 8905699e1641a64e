// SPDX-License-Identifier: Apache-2.0
// Finds values for every possible combination of answers to conditions that are neither linear nor on windows, such as
// `x * x + y * y < 4.0`, with the solver Z3 (de Moura and Bjørner, Z3: an efficient SMT solver, TACAS 2008). Private to
// this component.
//
// Statement: if there is a result, it contains a value for each combination of answers that some value gives. Reason:
// the search asks the solver for a value with a combination that no earlier value gives, until the solver proves that
// there is none. The evaluator of the semantics evaluates each value again, and there is no result if it disagrees with
// the solver. There is also no result if the solver answers "unknown", or if only numbers that are not decimals give
// some combination (`x
// * x == 2.0`). The steps and the time of the solver are limited, so a slow machine may find no result where a fast
//   machine finds one.
#pragma once

#include <optional>
#include <vector>

#include "semantics/data/sampling.hpp"
#include "semantics/data/uses.hpp"

namespace robochart::ir {

/// Returns a value of the type for each combination of answers that some value gives. Returns no value if the program
/// was built without Z3 (has_solver), or if there are more than 4,096 combinations. Also returns no value if an
/// operator of a condition is not arithmetic, logic or a comparison of numbers, or if an operand may be undefined. The
/// search polls the budget of `sampling`.
[[nodiscard]] std::optional<std::vector<Value>> solve_answers(const System& system, const Sampling& sampling,
                                                              TypeId type, const std::vector<Condition>& conditions);

}  // namespace robochart::ir
