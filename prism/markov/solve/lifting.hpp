// SPDX-License-Identifier: Apache-2.0
// Solves the linear equations of a policy exactly by lifting.
//
// The equations are eliminated once, modulo a prime p. Then each round finds one digit of the solution's expansion in
// powers of p: the solution d, modulo p, for the current residual. The next residual is (residual - A d) / p, which is
// an integer (Dixon, Exact solution of linear equations using p-adic expansions, 1982). Fractions are reconstructed
// from sufficiently many digits. All steps except the last use small numbers, while the numbers in an elimination with
// fractions grow with every step.
//
// The result satisfies the equations exactly, which is checked. They have one solution if the policy leaves from every
// state, which is checked too. So neither the primes nor the guessed number of digits can lead to a wrong result.
#pragma once

#include "prism/markov/solve/elimination.hpp"

namespace robochart::markov {

/// The solution of x = constant + A x, where A and the constants are those of the policy. No value if the policy may
/// stay forever, or if the limit is reached.
[[nodiscard]] std::optional<std::vector<Rational>> lift_solution(const System<Rational>& system, const Policy& policy,
                                                                 const EliminationLimit& limit);

}  // namespace robochart::markov
