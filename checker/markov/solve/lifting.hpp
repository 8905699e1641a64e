// Linear equations of a policy, solved exactly by lifting.
//
// Modulo a prime p the equations are eliminated once. Then each round finds one digit of the solution's expansion in
// powers of p: the residue d of the solution of what is left, after which (what is left - A d) / p, a whole number, is
// left (Dixon, Exact solution of linear equations using p-adic expansions, 1982). From enough digits the fractions
// follow. All the work but for the last step is with small numbers, while those of an elimination with fractions grow
// with every step.
//
// What is returned satisfies the equations exactly, which is checked. They have one solution where the policy leaves
// from everywhere, which is checked too. So neither primes nor the guess of the number of digits can make a result
// wrong.
#pragma once

#include "checker/markov/solve/elimination.hpp"

namespace robochart::markov {

/// The solution of x = constant + A x, where A and the constants are those of the policy. Nothing where the policy may
/// stay for ever, or where the limit is reached.
[[nodiscard]] std::optional<std::vector<Rational>> lift(const System<Rational>& system, const Policy& policy,
                                                        const EliminationLimit& limit);

}  // namespace robochart::markov
