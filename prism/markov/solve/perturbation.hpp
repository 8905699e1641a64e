// SPDX-License-Identifier: Apache-2.0
// Bounds the values of small components for which residuals in floating point prove nothing. This happens, for example,
// if 2^40 steps are expected and choices are equally good.
#pragma once

#include <optional>

#include "prism/markov/solve/elimination.hpp"
#include "prism/markov/solve/interval.hpp"

namespace robochart::markov {

/// Solves the equations with all probabilities at their low bounds, in rational numbers. Then widens the optimum by the
/// possible effect of the true probabilities.
///
/// Suppose that the probabilities between different unknowns, and those of leaving, are within a factor 1+d of the low
/// bounds, and that 1 - p(i,i) is the sum of the others. Under each policy a value is a quotient of two sums of
/// products. Each product has at most n such factors, where n is the number of unknowns, and all signs are positive
/// (the matrix-tree theorem). So the value changes by at most the factor (1+d)^n in either direction, and so does the
/// optimum over all policies. Values grow with the constants, so the equations are solved for both bounds of the
/// constants. Policy iteration begins with `first`, a policy that leaves the component. Returns no value if the limit
/// is reached. `most` is an upper bound on all values.
[[nodiscard]] std::optional<SystemSolution<Interval>> rational_bounds(const System<Interval>& system, Policy first,
                                                                      Direction direction, double most,
                                                                      const EliminationLimit& limit);

}  // namespace robochart::markov
