// SPDX-License-Identifier: Apache-2.0
// Explains why a bound on a probability is violated, by the most probable paths that together violate it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "prism/explore/moves.hpp"
#include "prism/session/evaluator.hpp"

namespace robochart::prism {

/// A path, described with the names of the model.
struct ProbablePath {
    struct Step {
        std::vector<Move> by;  ///< the commands that caused the step; if there are several moves, one of them did
        std::string changes;   ///< "x=1, y=false": the variables that change; "": none
        std::string state;     ///< all variables
    };
    std::string from;  ///< the initial state
    std::vector<Step> steps;
    Enclosure probability;
};

/// Paths whose probabilities add up, since none is a prefix of another.
struct Counterexample {
    bool holds = true;       ///< the formula holds on these paths; if false, no continuation of them satisfies it
    bool never = false;      ///< the paths lead to states from which the formula cannot hold
    bool scheduled = false;  ///< for an mdp: the probabilities are those under the scheduler that maximises them
    std::vector<ProbablePath> paths;  ///< the most probable ones, at most `most_kept`
    std::uint64_t count = 0;          ///< number of paths in the sum
    Enclosure total;
    Real bound;           ///< the bound that the total must reach or exceed
    bool strict = true;   ///< must exceed
    bool enough = false;  ///< the total reaches the bound; otherwise there are too many paths
    static constexpr std::size_t most_kept = 100;
};

/// Explains a violated bound on P of F, G, U, W or R of state formulas in an initial state. Returns no value for other
/// properties, or if a scheduler would need to know the number of steps. Labels must have been replaced. Throws
/// EvaluationError, Undecided, LimitReached.
[[nodiscard]] std::optional<Counterexample> counterexample(const StateSpace& space, Code& code, const ExprPtr& question,
                                                           const EvaluatorOptions& options);

/// Returns the choices of a scheduler that attains the value of P or R without a step bound (within the width of the
/// enclosures). For each state, the result contains an index into the choices of the model. Throws the exceptions of
/// `counterexample`, and Undecided if no memoryless scheduler attains the value.
[[nodiscard]] std::vector<std::uint32_t> best_choices(const StateSpace& space, Code& code, const ExprPtr& question,
                                                      const EvaluatorOptions& options);

}  // namespace robochart::prism
