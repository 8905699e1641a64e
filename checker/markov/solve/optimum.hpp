// The values of one strongly connected component.
#pragma once

#include <string>

#include "checker/markov/solve/interval.hpp"
#include "checker/markov/solve/system.hpp"

namespace robochart::markov {

/// Every policy leaves with probability 1, or, where the minimum is asked for, one that does not has infinite value:
/// then the equations have one solution, which is the optimum (Bertsekas and Tsitsiklis, 1991).
struct Optimum {
    Direction direction;
    Precision precision;
};

/// By policy iteration, from a policy that leaves.
[[nodiscard]] SystemSolution<Rational> optimum(const System<Rational>& system, const Optimum& asked);

/// Enclosures; where they cannot be made as narrow as asked for, `shortfall` says why. `most`: no value is above it.
[[nodiscard]] SystemSolution<Interval> optimum(const System<Interval>& system, const Optimum& asked, double most,
                                               std::string& shortfall);

}  // namespace robochart::markov
