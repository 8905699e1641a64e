// Bounds for small components that no residual in floating point can prove: where 2^40 steps are expected, say, and
// choices are equally good.
#pragma once

#include <optional>

#include "checker/markov/solve/elimination.hpp"
#include "checker/markov/solve/interval.hpp"

namespace robochart::markov {

/// The optimum with rational numbers, of the equations with all probabilities at their low bounds, widened by what the
/// true probabilities can change.
///
/// Let the probabilities between different unknowns, and to outside, be within a factor 1+d of the low bounds, and 1 -
/// p(i,i) be the sum of the others. Under each policy a value is a quotient of two sums of products: of at most n such
/// factors, n the number of unknowns, and no sign but plus (the matrix-tree theorem). So it changes by at most the
/// factor (1+d)^n either way, and so does the best of them. Values grow with the constants; both bounds are solved.
/// Policy iteration begins with `first`, a policy that leaves. Nothing where the limit is reached. `most`: no value is
/// above it.
[[nodiscard]] std::optional<SystemSolution<Interval>> rational_bounds(const System<Interval>& system, Policy first,
                                                                      Direction direction, double most,
                                                                      const EliminationLimit& limit);

}  // namespace robochart::markov
