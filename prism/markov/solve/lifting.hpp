// SPDX-License-Identifier: Apache-2.0
// Solves the linear equations of a policy exactly by lifting.
//
// The equations are eliminated once, modulo a prime p. Then each round finds one digit of the solution's expansion in
// powers of p. The digit is the solution d, modulo p, for the current residual. The next residual is (residual - A d) /
// p, which is an integer (Dixon, Exact solution of linear equations using p-adic expansions, 1982). Fractions are
// reconstructed from sufficiently many digits. All steps except the last use small numbers, while the numbers in an
// elimination with fractions grow with every step.
//
// Two checks ensure that neither the primes nor the guessed number of digits can lead to a wrong result. The result
// must satisfy the equations exactly, and the policy must leave the component from every state, so that the equations
// have one solution.
#pragma once

#include "prism/markov/solve/elimination.hpp"

namespace robochart::markov {

/// Returns the solution of x = constant + A x, where A and the constants are those of the policy. Returns no value if
/// the policy may stay in the component forever, or if the limit is reached.
[[nodiscard]] std::optional<std::vector<Rational>> lift_solution(const System<Rational>& system, const Policy& policy,
                                                                 const EliminationLimit& limit);

}  // namespace robochart::markov
