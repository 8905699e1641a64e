// What P and R ask of one path.
#pragma once

#include <cstdint>
#include <optional>

#include "checker/prism/sampling/path_formula.hpp"
#include "checker/prism/sampling/path_rewards.hpp"
#include "checker/prism/sampling/walk.hpp"

namespace robochart::prism {

/// The answer of one path.
struct Sample {
    bool decided = false;     ///< within the steps that a path may have
    double value = 0;         ///< whether a formula holds, as 1 or 0; what was earned, which may be infinite
    std::uint64_t steps = 0;  ///< after which that was known
};

class PathQuestion {
public:
    /// `question` is P [ path ], or R [ F state ], [ C<=k ], [ I=k ]; labels are replaced, but for "deadlock" and
    /// "init". `walk` goes through the model of the code. Throws Unsampled, EvaluationError.
    PathQuestion(const Expr& question, const Instance& instance, Code& code, Walk& walk);

    /// Follows a path, at most so many steps. Throws EvaluationError, LimitReached.
    [[nodiscard]] Sample ask(const Draws& draws, std::uint64_t most_steps, diagnostics::Budget* budget);

private:
    [[nodiscard]] std::optional<double> answer();

    const Instance& instance_;
    Walk& walk_;
    Op kind_;                             ///< probability, eventually, cumulative, instantaneous
    std::optional<PathFormula> formula_;  ///< of the first two
    std::optional<PathRewards> rewards_;  ///< of the last three
    std::uint64_t steps_ = 0;             ///< of the last two
    double earned_ = 0;
};

}  // namespace robochart::prism
