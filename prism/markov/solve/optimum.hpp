// SPDX-License-Identifier: Apache-2.0
// Computes the optimal values of one strongly connected component.
#pragma once

#include <string>

#include "prism/markov/solve/interval.hpp"
#include "prism/markov/solve/system.hpp"

namespace robochart::markov {

/// The goal for the equations of a component. Either every policy must leave the component with probability 1, or, for
/// a minimum, every policy that does not leave it must have an infinite value. Then the equations have one solution,
/// which is the optimum (Bertsekas and Tsitsiklis, 1991).
struct Optimum {
    Direction direction;
    Precision precision;
};

/// Computes the optimum by policy iteration. The first policy leaves the component with probability 1.
[[nodiscard]] SystemSolution<Rational> optimum(const System<Rational>& system, const Optimum& goal);

/// Computes enclosures. If they cannot be made as narrow as requested, `shortfall` contains the reason. `most` is an
/// upper bound on all values.
[[nodiscard]] SystemSolution<Interval> optimum(const System<Interval>& system, const Optimum& goal, double most,
                                               std::string& shortfall);

}  // namespace robochart::markov
