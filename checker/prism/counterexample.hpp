// Why a bound on a probability is violated: the most probable paths that together are evidence of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "checker/prism/evaluator.hpp"
#include "checker/prism/explore/moves.hpp"

namespace robochart::prism {

/// A path in terms of the model.
struct ProbablePath {
    struct Step {
        std::vector<Move> by;  ///< what made it; more than one: one of these
        std::string changes;   ///< "x=1, y=false": the variables that have another value then; "": none
        std::string state;     ///< all of them
    };
    std::string from;  ///< the state in which it begins
    std::vector<Step> steps;
    Enclosure probability;
};

/// Paths whose probabilities add up, since none is the beginning of another.
struct Counterexample {
    bool holds = true;                ///< the formula holds on these paths; else it does not, however they go on
    bool never = false;               ///< ... since what it asks for cannot come any more
    bool scheduled = false;           ///< of an mdp: under the scheduler that makes them likeliest
    std::vector<ProbablePath> paths;  ///< the most probable ones, at most `most_kept`
    std::uint64_t count = 0;          ///< of all paths that were added up
    Enclosure total;
    Real bound;           ///< what the total is to exceed, or to reach
    bool strict = true;   ///< to exceed
    bool enough = false;  ///< it does; else there are too many paths, or infinitely many
    static constexpr std::size_t most_kept = 100;
};

/// For P with a bound of F, G, U, W or R of states that is violated in an initial state; nothing for other properties,
/// and where a scheduler would need to know how many steps were made. Labels are replaced. Throws EvaluationError,
/// Undecided, LimitReached.
[[nodiscard]] std::optional<Counterexample> counterexample(const StateSpace& space, Code& code, const ExprPtr& question,
                                                           const EvaluatorOptions& options);

/// The choices of a scheduler with which the value of P or R without a bound on the steps is attained (within the width
/// of enclosures), for each state an index into the choices of the model. Throws as above, Undecided also where there
/// is no such scheduler without memory.
[[nodiscard]] std::vector<std::uint32_t> best_choices(const StateSpace& space, Code& code, const ExprPtr& question,
                                                      const EvaluatorOptions& options);

}  // namespace robochart::prism
